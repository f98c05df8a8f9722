"""The HTTP face of the service: paths, bodies, problems."""
