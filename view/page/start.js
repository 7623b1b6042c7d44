
const page = new Page(readGame());
page.begin();
