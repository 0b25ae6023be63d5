import { useEffect } from "react";
import { kMostWatched } from "../../core/watching.ts";
import { useSession } from "../session/session.ts";

/** While the component is shown, the server tells how failsafes stand for these robots. */
export function useStandings(owner: string, robots: readonly number[]): void {
  const { connection } = useSession();
  const key = robots.slice(0, kMostWatched).join(" ");
  useEffect(() => {
    connection.watching.wish(owner, { details: key === "" ? [] : key.split(" ").map(Number), failsafes: key !== "" });
    return () => connection.watching.wish(owner, null);
  }, [connection, owner, key]);
}
