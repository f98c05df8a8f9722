"""Sessions that the service records itself."""
