"""Training and evaluation data: procedural shapes, simulated scenes and depth cameras, recordings on disk."""
