// Starts the page of a recorded game as soon as all its parts are there.

let page = null;
addEventListener("DOMContentLoaded", () => {
  page = new Page(readGame());
  page.begin();
});
