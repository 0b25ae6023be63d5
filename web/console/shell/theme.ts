import { useEffect } from "react";
import { useSession, useUi } from "../session/session.ts";

/** Light or dark on the whole page and on the map, by choice or as the system has it. */
export function useTheme(): void {
  const { model } = useSession();
  const choice = useUi("theme");
  useEffect(() => {
    const system = window.matchMedia("(prefers-color-scheme: dark)");
    const apply = () => {
      const theme = choice === "auto" ? (system.matches ? "dark" : "light") : choice;
      document.documentElement.dataset.theme = theme;
      if (model.get("map").theme !== theme) model.updateMap({ theme });
    };
    apply();
    system.addEventListener("change", apply);
    return () => system.removeEventListener("change", apply);
  }, [choice, model]);
}
