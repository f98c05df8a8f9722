"""The live page: static files, recordings to play, and one websocket a viewer."""
