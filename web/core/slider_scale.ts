// The places of a slider and the values there. Where a range spans several decades the slider goes by ratios, so that the
// usual value, a tenth and ten times of it can all be met with the mouse; else it is even. Pure.

/** Places of a slider: 0 .. kSliderEnd. */
export const kSliderEnd = 1000;
/** What one press of an arrow key moves it: some per cent of the value where it goes by ratios, a two hundredth of the range else. */
export const kSliderStep = 5;

export interface Range {
  min: number;
  max: number;
  /** What the author wrote; NaN: nothing. */
  usual: number;
  isWhole: boolean;
}

export type Scale =
  | { kind: "even"; min: number; max: number; isWhole: boolean }
  /** By ratios on both sides of the usual value, which stands at the share `at`. Below `floor` there is only `min`. */
  | { kind: "ratios"; min: number; max: number; isWhole: boolean; floor: number; usual: number; at: number }
  /** Both signs: even up to `small`, by ratios beyond. */
  | { kind: "signs"; min: number; max: number; isWhole: boolean; small: number };

const kWide = 20; // times the usual value, from where a range is one of several decades
const kUsualPlace = 0.4; // share of the slider
const kBelow = 100; // how many times smaller than the usual value the smallest one is that can be met
const kLeast = 1e-10; // what is smaller means nothing, and a hundredth of it could not be told from 0

export function sliderScale({ min, max, usual, isWhole }: Range): Scale {
  const even = { kind: "even" as const, min, max, isWhole };
  const isUsual = Number.isFinite(usual) && Math.abs(usual) >= kLeast;
  const size = isUsual ? Math.abs(usual) : isWhole ? 10 : 1; // what SI units are made for
  if (min < 0 && max > 0) {
    const far = Math.max(-min, max);
    return far > kWide * size ? { kind: "signs", min, max, isWhole, small: size / 10 } : even;
  }
  if (min < 0 || max <= kWide * size) return even;
  const floor = min > 0 ? min : size / kBelow;
  const middle = Math.max(size, floor * 1.01);
  // Where there is not much below the usual value, that gets no more of the slider than its share.
  const share = Math.log(middle / floor) / Math.log(max / floor);
  const at = middle > 4 * floor ? kUsualPlace : share;
  return { kind: "ratios", min, max, isWhole, floor, usual: middle, at };
}

export function placeOnSlider(scale: Scale, value: number): number {
  const held = Math.min(scale.max, Math.max(scale.min, value));
  return Math.round(kSliderEnd * Math.min(1, Math.max(0, shareOf(scale, held))));
}

/** The value there, with no more digits than a hand can mean; the ends are the range's own. */
export function valueOnSlider(scale: Scale, place: number): number {
  const { min, max, isWhole } = scale;
  if (place <= 0) return min;
  if (place >= kSliderEnd) return max;
  const value = Math.min(max, Math.max(min, valueAt(scale, place / kSliderEnd)));
  if (isWhole) return Math.min(Math.floor(max), Math.max(Math.ceil(min), Math.round(value)));
  const smallest = scale.kind === "even" ? (max - min) / kSliderEnd : 1e-12;
  const size = Math.max(Math.abs(value), smallest);
  const step = 10 ** (Math.floor(Math.log10(size)) - 2) * 2;
  return Math.min(max, Math.max(min, Number((Math.round(value / step) * step).toPrecision(6))));
}

function shareOf(scale: Scale, value: number): number {
  if (scale.kind === "even") return (value - scale.min) / (scale.max - scale.min);
  if (scale.kind === "signs") return (bent(value, scale.small) - lowest(scale)) / (highest(scale) - lowest(scale));
  const { floor, usual, max, at } = scale;
  if (value <= scale.min) return 0;
  if (value <= usual) return (at * Math.log(Math.max(value, floor) / floor)) / Math.log(usual / floor);
  return at + ((1 - at) * Math.log(value / usual)) / Math.log(max / usual);
}

function valueAt(scale: Scale, share: number): number {
  if (scale.kind === "even") return scale.min + (scale.max - scale.min) * share;
  if (scale.kind === "signs") {
    const at = lowest(scale) + (highest(scale) - lowest(scale)) * share;
    return Math.sign(at) * scale.small * Math.expm1(Math.abs(at));
  }
  const { floor, usual, max, at } = scale;
  if (share <= at) return floor * (usual / floor) ** (share / at);
  return usual * (max / usual) ** ((share - at) / (1 - at));
}

type Signs = Extract<Scale, { kind: "signs" }>;

function bent(value: number, small: number): number {
  return Math.sign(value) * Math.log1p(Math.abs(value) / small);
}

function lowest({ min, small }: Signs): number {
  return bent(min, small);
}

function highest({ max, small }: Signs): number {
  return bent(max, small);
}
