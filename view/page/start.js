// Starts the page of a recorded game.

const page = new Page(readGame());
page.begin();
