// Keys of running.
export const kRunKey = "ctrl+enter";
export const kStepKey = ".";
export const kStopKey = "ctrl+.";
export const kFieldKey = "v";
export const kBreakKey = "ctrl+b";
export const kPinKey = "shift+p";
