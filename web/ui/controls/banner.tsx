// One line over the page that people have to know.
import type { ReactNode } from "react";

interface BannerProps {
  tone: "danger" | "hold" | "accent" | "past";
  children: ReactNode;
  /** `alert` is said at once to who listens to the page. */
  role?: "status" | "alert";
  /** On a narrow page a panel hides it: what it says is said elsewhere, too, and it would lie over the panel's head. */
  isYielding?: boolean;
}

export function Banner({ tone, children, role = "status", isYielding = false }: BannerProps) {
  return (
    <div className={`banner ${tone}${isYielding ? " yielding" : ""}`} role={role}>
      {children}
    </div>
  );
}
