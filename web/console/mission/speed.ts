// The speed slider: from a tenth of real time to a thousand times, one decade per third of its way, and then max.

export const kSlowest = 0.1;
export const kFastest = 1000;
export const kPresets: readonly number[] = [0.1, 0.5, 1, 2, 5, 10, 20, 50, 100, 1000, 0];

const kSteps = 160; // of the slider, 40 a decade
export const kSliderEnd = kSteps + 1; // the last place is max

/** Where the slider stands, 0..kSliderEnd. */
export function sliderOf(speed: number): number {
  if (speed === 0) return kSliderEnd;
  const bounded = Math.min(kFastest, Math.max(kSlowest, speed));
  return Math.round((Math.log10(bounded / kSlowest) / 4) * kSteps);
}

/** The speed there, with two digits that matter. */
export function speedOf(slider: number): number {
  if (slider >= kSliderEnd) return 0;
  const speed = kSlowest * 10 ** ((Math.max(0, slider) / kSteps) * 4);
  return Number(speed.toPrecision(2));
}

/** The next preset above or below. */
export function neighbour(speed: number, direction: 1 | -1): number {
  const order = kPresets.map((preset) => (preset === 0 ? Number.POSITIVE_INFINITY : preset));
  const here = speed === 0 ? Number.POSITIVE_INFINITY : speed;
  const found = direction > 0 ? order.find((preset) => preset > here) : order.findLast((preset) => preset < here);
  const next = found ?? here;
  return Number.isFinite(next) ? next : 0;
}
