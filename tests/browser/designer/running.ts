// What is drawn, running beside the canvas.
import { expect } from "vitest";
import { begin, type DesignerPage } from "./designer.ts";

export const kWander = `assemblage Wander() {
  cooperate {
    1: Noise(persistence = 2 s);
    0.5: AvoidStaticObstacles(readings = sense_obstacles(range = 2 m), sphere = 1 m, safety_margin = 0.3 m);
  }
}
`;

/** @param delay  of both transitions [s] */
export const turns = (delay: number) => `assemblage Turns() {
  sequence {
    start Waiting: Stand();
      when Wait(delay = ${delay} s) goto Moving;
    Moving: Noise(persistence = 2 s);
      when Wait(delay = ${delay} s) goto Waiting;
  }
}
`;

export const opened = (text: string) =>
  begin({ file: "one.cdl", prepare: (project) => project.write("one.cdl", text), width: 1600, height: 900 });

/** Simulated time [s]. */
export async function time({ page }: DesignerPage): Promise<number> {
  const text = (await page.getByTestId("sim-time").textContent()) ?? "";
  return text.split(":").reduce((sum, part) => sum * 60 + Number(part), 0);
}

export async function run(designer: DesignerPage): Promise<void> {
  await designer.run();
  await expect.poll(() => time(designer)).toBeGreaterThan(0.5);
}
