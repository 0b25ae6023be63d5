// The one StickControl of the page, joined to what moves it and to the connection.
import { useEffect, useSyncExternalStore } from "react";
import type { Connection } from "../../core/connection.ts";
import type { Model } from "../../core/model.ts";
import { usePart, useSession } from "../session/session.ts";
import { StickControl } from "./control.ts";
import { driveKeyOf } from "./stick.ts";

/** Held anywhere on the page, outside of text fields, it hands the drive keys to the active stick. */
export const kHoldKey = "KeyH";

const kPollInterval = 20; // ms; sticks are sent every 50

const kControls = new WeakMap<Connection, StickControl>();

/** Sticks outlive the panel, so that hiding it changes nothing but lets go of them. */
export function sticksOf(connection: Connection): StickControl {
  let control = kControls.get(connection);
  if (!control) {
    control = new StickControl(
      (unit, { stick, robotFrame }) =>
        connection.tell({ case: "stick", value: { unit, x: stick.x, y: stick.y, robotFrame } }),
      () => performance.now(),
    );
    kControls.set(connection, control);
  }
  return control;
}

/** Draws the component anew when a stick moves. */
export function useSticks(): StickControl {
  const { connection } = useSession();
  const control = sticksOf(connection);
  useSyncExternalStore(control.subscribe, control.snapshot);
  return control;
}

/** Feeds the sticks as long as the panel stands; when it goes, they are let go. */
export function useStickSources(units: readonly string[]): void {
  const { model, connection } = useSession();
  const link = usePart("link").state;
  const control = sticksOf(connection);
  const key = units.join("\n");
  useEffect(() => control.setUnits(key === "" ? [] : key.split("\n")), [control, key]);
  useEffect(() => {
    if (link !== "open") control.stopAll();
  }, [control, link]);
  useEffect(() => (key === "" ? undefined : listen(control, model)), [control, model, key]);
}

function listen(control: StickControl, model: Model): () => void {
  let isHandedOver = false;
  const stop = () => {
    isHandedOver = false;
    control.stopAll();
  };
  const whenHidden = () => {
    if (document.visibilityState === "hidden") stop();
  };
  const down = (event: KeyboardEvent) => {
    if (event.code === kHoldKey && !isText(event.target) && !hasModifier(event)) {
      isHandedOver = true;
      event.preventDefault();
      return;
    }
    const drive = driveKeyOf(event.code);
    if (!drive || !(isHandedOver || isPad(event.target)) || hasModifier(event)) {
      if (event.key === "Shift") control.setSlow(true);
      return;
    }
    event.preventDefault();
    event.stopPropagation();
    if (model.mayOrder()) control.pressKey(drive, event.shiftKey);
  };
  const up = (event: KeyboardEvent) => {
    if (event.code === kHoldKey && isHandedOver) {
      isHandedOver = false;
      control.releaseKeys();
    }
    if (event.key === "Shift") control.setSlow(false);
    const drive = driveKeyOf(event.code);
    if (drive) control.releaseKey(drive, event.shiftKey);
  };
  const poll = setInterval(() => {
    if (model.mayOrder() && document.hasFocus()) control.readPad(firstPad());
    control.tick();
  }, kPollInterval);
  window.addEventListener("keydown", down, true);
  window.addEventListener("keyup", up, true);
  window.addEventListener("blur", stop);
  window.addEventListener("pagehide", stop);
  document.addEventListener("visibilitychange", whenHidden);
  return () => {
    clearInterval(poll);
    window.removeEventListener("keydown", down, true);
    window.removeEventListener("keyup", up, true);
    window.removeEventListener("blur", stop);
    window.removeEventListener("pagehide", stop);
    document.removeEventListener("visibilitychange", whenHidden);
    stop();
  };
}

function firstPad(): Gamepad | null {
  return navigator.getGamepads?.().find((pad) => pad?.connected) ?? null;
}

function hasModifier(event: KeyboardEvent): boolean {
  return event.ctrlKey || event.metaKey || event.altKey;
}

function isPad(target: EventTarget | null): boolean {
  return target instanceof Element && target.closest("[data-stick]") !== null;
}

function isText(target: EventTarget | null): boolean {
  return (
    target instanceof HTMLElement &&
    (target.isContentEditable || ["INPUT", "TEXTAREA", "SELECT"].includes(target.tagName))
  );
}
