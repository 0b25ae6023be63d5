// Triggers that ask nothing, in words: CDL writes them as a constant.
const kWords = {
  "at once": /^(?:true|Constant\(\s*(?:(?:value\s*=\s*)?true)?\s*\))$/,
  never: /^(?:false|Constant\(\s*(?:value\s*=\s*)?false\s*\))$/,
} as const;
const kTexts: Readonly<Record<string, string>> = {
  "at once": "Constant()",
  immediate: "Constant()",
  immediately: "Constant()",
  always: "Constant()",
  never: "Constant(value = false)",
};

/** As it is read: `at once`, `never`, or the text. */
export function triggerWords(trigger: string): string {
  const text = trigger.trim();
  for (const [words, constant] of Object.entries(kWords)) if (constant.test(text)) return words;
  return trigger;
}

/** As CDL has it, of what somebody has typed. */
export function triggerText(typed: string): string {
  return kTexts[typed.trim().toLowerCase()] ?? typed;
}
