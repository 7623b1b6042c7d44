// Display names of commands, stages, events and possession chains.

const kSideNames = ["yellow", "blue"];

const kEventTitles = {
  goal: "Goal",
  throw_in: "Throw-in",
  touch_line_unknown: "Over the touch line, last touch unknown",
  goal_line_unknown: "Over the goal line, last touch unknown",
  restart_not_taken: "Restart not taken in time",
  half_over: "End of the half",
  game_over: "End of the game",
  bot_crash_unique: "Crash",
  bot_crash_drawn: "Crash, both at fault",
  card_over: "Yellow card over",
  shootout: "Shoot-out",
  shootout_over: "End of the shoot-out",
};

function capitalised(text) {
  return text.charAt(0).toUpperCase() + text.slice(1);
}

// The end that yellow defends: 0 is at -x, 1 at +x.
function endOfYellow({yellowDefends}) {
  return yellowDefends === "east" ? 1 : 0;
}

// "CORNER_KICK" or "corner_kick" becomes "Corner kick".
function plain(word) {
  return capitalised(word.toLowerCase().replaceAll("_", " "));
}

function eventTitle(event) {
  return kEventTitles[event] ?? plain(event);
}

// The side of a command: 0 yellow, 1 blue, null for both.
function sideOfCommand(command) {
  if (command.endsWith("_YELLOW")) return 0;
  return command.endsWith("_BLUE") ? 1 : null;
}

function kindOfCommand(command) {
  return command.replace(/_(YELLOW|BLUE)$/, "");
}

function isCommand(text) {
  return /^[A-Z_]+$/.test(text);
}

// "DIRECT_FREE_BLUE" becomes "Direct free kick, blue".
function commandTitle(command) {
  const side = sideOfCommand(command);
  const kind = plain(kindOfCommand(command)).replace("free", "free kick").replace("kickoff", "kick-off");
  return side === null ? kind : `${kind}, ${kSideNames[side]}`;
}

function kickTitle({number, side, scored, standing}) {
  return `Kick ${number} of ${kSideNames[side]}: ${scored ? "goal" : "no goal"}, ${standing[0]}\u00a0:\u00a0${standing[1]}`;
}

function stageTitle(stage) {
  if (stage === "SHOOTOUT") return "Shoot-out";
  return plain(stage.replace(/_PRE$/, "")) + (stage.endsWith("_PRE") ? ", about to begin" : "");
}

// Beginnings and ends of possession chains whose names are not clear by themselves.
const kChainTitles = {
  kick_off: "Kick-off",
  throw_in: "Throw-in",
  lost: "Ball lost",
  out: "Ball out",
  whistle: "Play stopped",
};

function chainKindTitle(kind) {
  return kChainTitles[kind] ?? plain(kind);
}

// "Yellow: interception, 2 passes, shot (xG 0.12), ball out"
function chainTitle({side, start, end, passes, shots, xg}) {
  const parts = [chainKindTitle(start).toLowerCase()];
  if (passes > 0) parts.push(passes === 1 ? "1 pass" : `${passes} passes`);
  if (shots > 0) parts.push(`${shots === 1 ? "shot" : `${shots} shots`} (xG ${xg.toFixed(2)})`);
  if (end !== "shot" || shots === 0) parts.push(chainKindTitle(end).toLowerCase());
  return `${capitalised(kSideNames[side])}: ${parts.join(", ")}`;
}

// "+0.02"
function signedText(number) {
  const size = Math.abs(number).toFixed(2);
  if (Number(size) === 0) return size;
  return `${number < 0 ? "\u2212" : "+"}${size}`;
}

// "5 dribble +0.02"
function actionTitle({robot, kind, worth}) {
  return `${robot < 0 ? "" : `${robot} `}${kind} ${signedText(worth)}`;
}

function shotTitle({time_s, side, xg, hasScored}) {
  const result = hasScored ? "goal" : "shot";
  return `${minutesAndSeconds(time_s)}  ${capitalised(kSideNames[side])}: ${result}, xG ${xg.toFixed(2)}`;
}

// The teams' names, or their colours if the names are unknown. Colours also distinguish teams with the same name.
function shownNames(teams) {
  return teams.map((name, side) => {
    if (!name) return capitalised(kSideNames[side]);
    return teams[0] === teams[1] ? `${name} (${kSideNames[side]})` : name;
  });
}

function twoDigits(number) {
  return String(number).padStart(2, "0");
}

// 83.25 becomes "1:23".
function minutesAndSeconds(time_s) {
  const whole = Math.max(0, Math.floor(time_s + 1e-9));
  return `${Math.floor(whole / 60)}:${twoDigits(whole % 60)}`;
}

// 83.25 becomes "1:23.25".
function hundredths(time_s) {
  const all = Math.max(0, Math.round(time_s * 100));
  return `${minutesAndSeconds(Math.floor(all / 100))}.${twoDigits(all % 100)}`;
}
