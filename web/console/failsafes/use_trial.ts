import { useEffect, useState } from "react";
import { useSession } from "../session/session.ts";
import type { Order } from "./conditions.ts";
import { type Answer, kept, keyOf, kNothingTried, kUnderWay } from "./trying.ts";

export interface Trial {
  answer: Answer | null;
  isUnderWay: boolean;
  /** Nothing while one is under way, or without an order. */
  tryIt: () => Promise<void>;
}

/** Has the server try it when somebody asks; an answer goes as soon as the order is another. */
export function useTrial(order: Order | undefined): Trial {
  const { connection } = useSession();
  const [before, setTrying] = useState(kNothingTried);
  const now = keyOf(order);
  const trying = kept(before, now);
  // Not to come back with the same conditions later: the robot may be elsewhere by then.
  useEffect(() => {
    if (trying !== before) setTrying((newest) => kept(newest, now));
  }, [trying, before, now]);
  const tryIt = async () => {
    if (!order || trying.isUnderWay) return;
    setTrying(kUnderWay);
    const reply = await connection.ask({ case: "tryFailsafes", value: order });
    const found = reply.ok && reply.result.case === "failsafes" ? { trial: reply.result.value } : null;
    setTrying({
      isUnderWay: false,
      answer: { of: now, is: found ?? { error: reply.error || "the server did not answer" } },
    });
  };
  return { answer: trying.answer?.is ?? null, isUnderWay: trying.isUnderWay, tryIt };
}
