// One line over the page that people have to know.
import type { ReactNode } from "react";

interface BannerProps {
  tone: "danger" | "hold" | "accent" | "past";
  children: ReactNode;
  /** `alert` is said at once to who listens to the page. */
  role?: "status" | "alert";
}

export function Banner({ tone, children, role = "status" }: BannerProps) {
  return (
    <div className={`banner ${tone}`} role={role}>
      {children}
    </div>
  );
}
