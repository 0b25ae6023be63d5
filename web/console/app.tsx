import { useEffect, useRef } from "react";
import { type Session, SessionContext, usePart, useSession } from "./session.ts";

export function App({ session }: { session: Session }) {
  return (
    <SessionContext value={session}>
      <Clock />
      <Dots />
    </SessionContext>
  );
}

function Clock() {
  const time = usePart("time");
  const link = usePart("link");
  return <p role="status">{link.state === "open" ? `${time.toFixed(1)} s` : `${link.state}: ${link.reason}`}</p>;
}

function Dots() {
  const { model } = useSession();
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const draw = () => {
      const pen = canvas.current?.getContext("2d");
      const scene = model.get("scene");
      if (!pen || !scene) return;
      const scale = Math.min(800 / scene.width, 600 / scene.height);
      pen.clearRect(0, 0, 800, 600);
      for (let row = 0; row < model.robots.count; ++row) {
        pen.fillStyle = model.get("roster").robot(model.robots.id(row))?.color ?? "gray";
        pen.fillRect(model.robots.x(row) * scale - 2, 600 - model.robots.y(row) * scale - 2, 4, 4);
      }
    };
    return model.onFrame(draw);
  }, [model]);
  return <canvas ref={canvas} width={800} height={600} />;
}
