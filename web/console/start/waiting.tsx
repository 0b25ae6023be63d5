import { usePart } from "../session/session.ts";

/** Before the server has said anything. */
export function Waiting() {
  const link = usePart("link");
  const isRefused = link.state === "refused";
  return (
    <main className="start">
      <div className="start-box" role="status">
        <h1>{isRefused ? "The server refuses this page" : "Connecting…"}</h1>
        <p className="muted">
          {isRefused
            ? "Its address carries a token that changes with each start. Open the address that mlab printed last."
            : link.state === "lost"
              ? "No answer yet. Is mlab still running? This page keeps trying."
              : "This takes a moment."}
        </p>
        {link.reason && <p className="mono small muted">{link.reason}</p>}
      </div>
    </main>
  );
}
