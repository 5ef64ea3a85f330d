"""What leaves the program in the formats of other software."""
