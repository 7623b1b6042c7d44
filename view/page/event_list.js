// The list of highlights with their reasons, and the line showing the latest one.

function textElement(tag, className, text) {
  const element = document.createElement(tag);
  element.className = className;
  element.textContent = text;
  return element;
}

function highlightItem(highlight, seek) {
  const button = document.createElement("button");
  button.type = "button";
  button.className = `highlight ${highlight.kind}`;
  button.classList.toggle("missed", highlight.isMissed === true);
  button.classList.toggle("disagreement", highlight.isDisagreement === true);
  button.dataset.side = highlight.side ?? "";
  button.dataset.color = highlight.color ?? "";
  button.append(textElement("span", "when", minutesAndSeconds(highlight.time_s)),
                textElement("span", "title", highlight.title));
  if (highlight.reason) button.append(textElement("span", "reason", highlight.reason));
  if (highlight.rule) button.append(textElement("span", "rule", highlight.rule));
  button.addEventListener("click", () => seek(highlight.time_s));
  const item = document.createElement("li");
  item.append(button);
  return item;
}

class EventList {
  constructor(highlights, seek) {
    this.highlights = highlights;
    this.list = document.getElementById("eventList");
    this.current = -1;
    this.hasOnlyDisagreements = false;
    const items = document.createDocumentFragment();
    for (const highlight of highlights) items.append(highlightItem(highlight, seek));
    this.list.append(items);
    if (highlights.length === 0) this.list.append(textElement("li", "none", "The log contains no events."));
  }

  // The latest highlight up to this time.
  highlightAt(time_s) {
    return this.highlights[this.indexAt(time_s)] ?? null;
  }

  indexAt(time_s) {
    return lastNotAfter(this.highlights, time_s + 1e-6, (highlight) => highlight.time_s);
  }

  // The next highlight of this kind, forwards (1) or backwards (-1); of any kind if `kind` is null.
  neighbour(time_s, direction, kind = null) {
    const isListed = (highlight) => !this.hasOnlyDisagreements || highlight.isDisagreement === true;
    const fits = (highlight) => isListed(highlight) && (kind === null || highlight.kind === kind);
    const lies = (highlight) => direction * (highlight.time_s - time_s) > 1e-3;
    const ahead = this.highlights.filter((highlight) => fits(highlight) && lies(highlight));
    return direction > 0 ? ahead[0] : ahead[ahead.length - 1];
  }

  show(time_s) {
    const index = this.indexAt(time_s);
    if (index === this.current) return;
    this.list.querySelector("[aria-current]")?.removeAttribute("aria-current");
    this.current = index;
    this.announce(this.highlights[index]);
    if (index < 0) return;
    this.list.children[index].firstChild.setAttribute("aria-current", "true");
    this.reveal();
  }

  // Scrolls only the list, to the current highlight.
  reveal() {
    const {list} = this;
    const item = list.children[this.current];
    if (!item || item.offsetParent === null) return;  // there is none, or it is hidden
    list.scrollTop = item.offsetTop - list.offsetTop - (list.clientHeight - item.offsetHeight) / 2;
  }

  announce(highlight) {
    setText("callTitle", highlight ? `${minutesAndSeconds(highlight.time_s)}  ${highlight.title}` : "");
    setText("callReason", highlight?.reason ?? "");
    const call = document.getElementById("call");
    call.dataset.kind = highlight?.kind ?? "";
    call.dataset.side = highlight?.side ?? "";
  }
}
