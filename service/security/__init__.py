"""Who may do what: keys and tokens for REST, secrets for clouds, certificates and rules for Zenoh."""
