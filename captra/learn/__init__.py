"""PyTorch: the networks and how they are trained; the service imports none of it."""
