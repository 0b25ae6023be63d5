import { type Log_Entry, Log_Kind } from "../../core/protocol.ts";

/** Alerts that nobody has dismissed, oldest first; of the same robot and kind only the newest. */
export function openAlerts(log: readonly Log_Entry[], to: bigint, dismissed: ReadonlySet<bigint>): Log_Entry[] {
  const newest = new Map<string, Log_Entry>();
  for (const entry of log) {
    // What a person did, they know, and a stop has its banner.
    if (!entry.isAlert || entry.number <= to || entry.kind === Log_Kind.OPERATOR) continue;
    const key = entry.robot !== 0 ? `${entry.kind} ${entry.robot}` : `entry ${entry.number}`;
    newest.delete(key);
    if (!dismissed.has(entry.number)) newest.set(key, entry);
  }
  return [...newest.values()];
}
