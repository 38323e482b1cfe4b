"""The rivals: each a folder with `build.py`, which makes what can be timed of a linkage."""
