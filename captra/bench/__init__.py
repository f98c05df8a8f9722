"""How fast the tracker is on this machine."""
