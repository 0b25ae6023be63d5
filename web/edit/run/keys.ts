// Keys of running.
export const kRunKey = "f9";
export const kStepKey = "f10";
export const kStopKey = "shift+f9";
export const kFieldKey = "v";
export const kBreakKey = "ctrl+b";
export const kPinKey = "shift+p";
