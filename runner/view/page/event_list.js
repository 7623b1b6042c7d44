// The list of moments with their reasons, and the line that tells the last one.

function textElement(tag, className, text) {
  const element = document.createElement(tag);
  element.className = className;
  element.textContent = text;
  return element;
}

function momentItem(moment, seek) {
  const button = document.createElement("button");
  button.type = "button";
  button.className = `moment ${moment.kind}`;
  button.dataset.side = moment.side ?? "";
  button.dataset.color = moment.color ?? "";
  button.append(textElement("span", "when", minutesAndSeconds(moment.time_s)),
                textElement("span", "title", moment.title));
  if (moment.reason) button.append(textElement("span", "reason", moment.reason));
  if (moment.rule) button.append(textElement("span", "rule", moment.rule));
  button.addEventListener("click", () => seek(moment.time_s));
  const item = document.createElement("li");
  item.append(button);
  return item;
}

class EventList {
  constructor(moments, seek) {
    this.moments = moments;
    this.list = document.getElementById("eventList");
    this.current = -1;
    const items = document.createDocumentFragment();
    for (const moment of moments) items.append(momentItem(moment, seek));
    this.list.append(items);
    if (moments.length === 0) this.list.append(textElement("li", "none", "The log tells of no events."));
  }

  // The last moment until then.
  momentAt(time_s) {
    return this.moments[this.indexAt(time_s)] ?? null;
  }

  indexAt(time_s) {
    return lastNotAfter(this.moments, time_s + 1e-6, (moment) => moment.time_s);
  }

  // The next moment of that kind, forwards (1) or backwards (-1); all kinds where there is none.
  neighbour(time_s, direction, kind = null) {
    const fits = (moment) => kind === null || moment.kind === kind;
    const lies = (moment) => direction * (moment.time_s - time_s) > 1e-3;
    const ahead = this.moments.filter((moment) => fits(moment) && lies(moment));
    return direction > 0 ? ahead[0] : ahead[ahead.length - 1];
  }

  show(time_s) {
    const index = this.indexAt(time_s);
    if (index === this.current) return;
    this.list.querySelector("[aria-current]")?.removeAttribute("aria-current");
    this.current = index;
    this.tell(this.moments[index]);
    if (index < 0) return;
    this.list.children[index].firstChild.setAttribute("aria-current", "true");
    this.reveal();
  }

  // Scrolls the list, and nothing else, to the current moment.
  reveal() {
    const {list} = this;
    const item = list.children[this.current];
    if (!item) return;
    list.scrollTop = item.offsetTop - list.offsetTop - (list.clientHeight - item.offsetHeight) / 2;
  }

  tell(moment) {
    setText("callTitle", moment ? `${minutesAndSeconds(moment.time_s)}  ${moment.title}` : "");
    setText("callReason", moment?.reason ?? "");
    const call = document.getElementById("call");
    call.dataset.kind = moment?.kind ?? "";
    call.dataset.side = moment?.side ?? "";
  }
}
