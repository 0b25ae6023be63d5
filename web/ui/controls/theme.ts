import { useEffect } from "react";

export type ThemeChoice = "auto" | "light" | "dark";

/** Light or dark on the whole page, by choice or as the system has it; `told` hears which. */
export function useTheme(choice: ThemeChoice, told?: (theme: "light" | "dark") => void): void {
  useEffect(() => {
    const system = window.matchMedia("(prefers-color-scheme: dark)");
    const apply = () => {
      const theme = choice === "auto" ? (system.matches ? "dark" : "light") : choice;
      document.documentElement.dataset.theme = theme;
      told?.(theme);
    };
    apply();
    system.addEventListener("change", apply);
    return () => system.removeEventListener("change", apply);
  }, [choice, told]);
}
