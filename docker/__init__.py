"""The image: its steps as scripts, and what plays the Dockerfile through where no container engine runs."""
