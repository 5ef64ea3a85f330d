"""Package in which pyserial finds the handler of ``sim://`` addresses."""
