// The possession chains, shots and actions of a game, and the filter that selects some of them.

const kSameMoment_s = 1e-3;

// The elements of the arrays of a chain, a shot and an action (view/page.cpp).
function chainOf([start_s, end_s, side, start, end, passes, shots, xg]) {
  return {start_s, end_s, side, start, end, passes, shots, xg};
}

function shotOf([time_s, side, position_mm, xg, hasScored]) {
  return {time_s, side, position_mm, xg, hasScored};
}

function actionOf([start_s, end_s, side, robot, kind, from_mm, to_mm, worth]) {
  return {start_s, end_s, side, robot, kind, from_mm, to_mm, worth};
}

// Chains do not overlap and are sorted by time; shots are sorted by the ends of their chains.
class Chains {
  constructor({chains, shots, actions}) {
    this.chains = [];
    this.shots = [];
    this.actions = [];  // sorted by their ends
    this.filter = {side: "", start: "", end: "", isWithShot: false};  // empty texts match everything
    this.add(chains, shots);
    for (const action of actions.map(actionOf)) {
      const chain = this.chainWith({time_s: action.start_s, side: action.side});
      this.actions.push({...action, chain});
    }
  }

  // Call with a shot's chain before or with the shot.
  add(chains, shots) {
    this.chains.push(...chains.map(chainOf));
    for (const shot of shots.map(shotOf)) this.shots.push({...shot, chain: this.chainWith(shot)});
  }

  clear() {
    this.chains.length = 0;
    this.shots.length = 0;
    this.actions.length = 0;
  }

  chainWith({time_s, side}) {
    return this.chains.findLast((chain) => chain.side === side && chain.start_s <= time_s + kSameMoment_s);
  }

  matches(chain) {
    const {side, start, end, isWithShot} = this.filter;
    const fits = (wanted, value) => wanted === "" || wanted === String(value);
    return fits(side, chain.side) && fits(start, chain.start) && fits(end, chain.end) &&
      (!isWithShot || chain.shots > 0);
  }

  matchingChains() {
    return this.chains.filter((chain) => this.matches(chain));
  }

  matchingShots() {
    return this.shots.filter(({chain}) => chain && this.matches(chain));
  }

  matchingActions() {
    return this.actions.filter(({chain}) => chain && this.matches(chain));
  }

  // What the team of the chain did with the ball.
  actionsOf(chain) {
    return this.actions.filter((action) => action.chain === chain && action.kind !== "foul");
  }

  // The chain in progress at this time, or null. A chain can last for no time: of several, one that
  // matches is preferred.
  chainAt(time_s) {
    const isInProgress = ({start_s, end_s}) => start_s <= time_s + kSameMoment_s && time_s <= end_s + kSameMoment_s;
    const inProgress = this.chains.filter(isInProgress);
    return inProgress.findLast((chain) => this.matches(chain)) ?? inProgress.at(-1) ?? null;
  }

  // The next matching chain to begin, forwards (1) or backwards (-1).
  neighbour(time_s, direction) {
    const lies = (chain) => direction * (chain.start_s - time_s) > kSameMoment_s;
    const ahead = this.matchingChains().filter(lies);
    return direction > 0 ? ahead[0] : ahead[ahead.length - 1];
  }

  // The expected goals of yellow and blue up to this time.
  xgAt(time_s) {
    const sums = [0, 0];
    for (const shot of this.shots) {
      if (shot.time_s <= time_s + kSameMoment_s) sums[shot.side] += shot.xg;
    }
    return sums;
  }
}
