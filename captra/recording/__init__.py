"""Sessions in MCAP files: written by clients and by the service, opened by Foxglove and Rerun, replayed."""
