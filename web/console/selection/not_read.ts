import { sentence } from "../../ui/words/sentence.ts";

/** Why messages of a robot could not be read. What is told of an agent may leave out whose it is. */
export function whyNotRead(error: string, machine: string): string {
  const isOfAgent = machine !== "" && /^(is|was|has|does|refuses|can't|could) /.test(error);
  return sentence(`messages can't be read: ${isOfAgent ? `the agent on \`${machine}\` ` : ""}${error}`);
}
