"""Finding out how the instrument on the bench departs from its profile."""
