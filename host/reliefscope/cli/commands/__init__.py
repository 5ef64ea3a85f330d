"""One module per subcommand or small group of them."""
