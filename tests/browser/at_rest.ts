import { expect } from "vitest";

/** What `look` tells, once it tells the same several times running: on a busy machine a page takes its time to settle. */
export async function atRest<Told>(look: () => Promise<Told>): Promise<Told> {
  let told = await look();
  let same = 0;
  const again = async () => {
    const now = await look();
    same = JSON.stringify(now) === JSON.stringify(told) ? same + 1 : 0;
    told = now;
    return same;
  };
  await expect.poll(again, { interval: 100, timeout: 30_000 }).toBeGreaterThan(3);
  return told;
}
