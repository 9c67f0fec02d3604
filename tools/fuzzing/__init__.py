"""Hostile parameters and files for every algorithm, tried in a process that may die of them."""
