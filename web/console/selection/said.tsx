import { useEffect, useRef, useState } from "react";
import type { Said } from "../../core/protocol.ts";
import { Button } from "../../ui/controls/controls.tsx";
import { sentence } from "../../ui/words/sentence.ts";
import { useSession } from "../session/session.ts";

/** What a robot's program and the agent of its machine said last, read when somebody asks; of one machine alone. */
export function SaidThere({ robot, machine }: { robot: number; machine: string }) {
  const { connection } = useSession();
  const [said, setSaid] = useState<Said | undefined>();
  const [readAt, setReadAt] = useState(0);
  const [problem, setProblem] = useState("");
  const [isReading, setIsReading] = useState(false);
  const section = useRef<HTMLElement>(null);
  // What was asked for stands below everything else.
  useEffect(() => {
    if (said || problem) section.current?.scrollIntoView({ block: "nearest" });
  }, [said, problem]);
  const read = async () => {
    setIsReading(true);
    const reply = await connection.ask({ case: "readSaid", value: { robot } });
    setIsReading(false);
    setProblem(reply.ok ? "" : sentence(`messages can't be read: ${reply.error}`));
    if (reply.result.case !== "said") return;
    setSaid(reply.result.value);
    setReadAt(Date.now());
  };
  return (
    <section ref={section} className="rows said" aria-label="Messages">
      <Button isPending={isReading} onPress={() => void read()}>
        {said ? "Read messages again" : "Read messages"}
      </Button>
      {problem && (
        <p className="notice danger" role="alert">
          {problem}
        </p>
      )}
      {problem && said && <p className="small muted">What follows was read at {clock(readAt)}.</p>}
      {said && (
        <>
          <h3>Its program</h3>
          {said.program ? (
            <pre className="mono">{said.program}</pre>
          ) : (
            <p className="muted">It has written nothing to standard error.</p>
          )}
          <h3>{machine ? `The agent on ${machine}` : "Its machine"}</h3>
          {said.machine.length > 0 ? (
            <pre className="mono">{said.machine.map((line) => lineText(line, readAt)).join("\n")}</pre>
          ) : (
            <p className="muted">{machine ? "It has told nothing." : "It is computed where the run is."}</p>
          )}
        </>
      )}
    </section>
  );
}

/** `14:03:12  a run has begun`, by the clock of who reads it. */
function lineText(line: { age: number; text: string }, readAt: number): string {
  return `${clock(readAt - line.age * 1000)}  ${line.text}`;
}

function clock(time: number): string {
  return new Date(time).toLocaleTimeString([], { hour12: false });
}
