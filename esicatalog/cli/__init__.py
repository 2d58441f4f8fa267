"""The shell command ``esicatalog``: argument parsing and printing, nothing else."""
