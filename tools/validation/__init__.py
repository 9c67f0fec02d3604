"""What the project's numbers were checked against, made by ``make validation``."""
