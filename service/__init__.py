"""The tracking service: poses by REST, clouds and results by Zenoh."""
