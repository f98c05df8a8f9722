"""`python -m captra`: the same as the console script, for interpreters whose scripts are not on the path."""

from captra.cli import main

main()
