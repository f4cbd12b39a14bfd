"""How the hand's tools are made. Lengths mm, the game's frame: +Y up, +X away from the clay, +Z to the visitor."""
