// Triggers that ask nothing, in words: CDL writes them as a constant.
export const kNoTrigger = "no trigger yet";

const kWords = {
  "at once": /^(?:true|Constant\(\s*(?:(?:value\s*=\s*)?true)?\s*\))$/,
  [kNoTrigger]: /^(?:false|Constant\(\s*(?:value\s*=\s*)?false\s*\))$/,
} as const;
const kTexts: Readonly<Record<string, string>> = {
  "at once": "Constant()",
  immediate: "Constant()",
  immediately: "Constant()",
  always: "Constant()",
  never: "Constant(value = false)",
  [kNoTrigger]: "Constant(value = false)",
  "": "Constant(value = false)",
};

/** Whether it is the one that a new transition has: never made, until something better is said. */
export function isNoTrigger(trigger: string): boolean {
  return kWords[kNoTrigger].test(trigger.trim());
}

/** As it is read: `at once`, `no trigger yet`, or the text. */
export function triggerWords(trigger: string): string {
  const text = trigger.trim();
  for (const [words, constant] of Object.entries(kWords)) if (constant.test(text)) return words;
  return trigger;
}

/** As CDL has it, of what somebody has typed. */
export function triggerText(typed: string): string {
  return kTexts[typed.trim().toLowerCase()] ?? typed;
}
