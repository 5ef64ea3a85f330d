"""From frames to a surface: pure functions over arrays and one thin pipeline over runs."""
