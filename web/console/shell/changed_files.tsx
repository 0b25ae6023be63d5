// What somebody else has done to the files of the mission that is open.
import { useEffect, useState } from "react";
import { Documents_Disk as Disk, type Documents_Document } from "../../core/protocol.ts";
import { ChangedFile } from "../../ui/files/changed_file.tsx";
import { order } from "../session/orders.ts";
import { useMayOrder, usePart, useSession } from "../session/session.ts";

export function ChangedFiles() {
  const documents = usePart("documents")?.documents ?? [];
  return documents.map((document) => <OneFile key={document.path} document={document} />);
}

function OneFile({ document: { path, disk, takenOver } }: { document: Documents_Document }) {
  const session = useSession();
  const mayOrder = useMayOrder();
  // What happened before this page saw the file is no news to it.
  const [seen, setSeen] = useState(takenOver);
  const [knowsItIsGone, setKnowsItIsGone] = useState(false);
  useEffect(() => {
    if (disk !== Disk.GONE) setKnowsItIsGone(false);
  }, [disk]);
  const isGone = disk === Disk.GONE && !knowsItIsGone;
  const what = disk === Disk.CHANGED ? "both" : isGone ? "gone" : takenOver > seen ? "taken" : undefined;
  if (!what) return null;
  const reload = (merge: boolean) => void order(session, { case: "reloadDocument", value: { document: path, merge } });
  return (
    <ChangedFile
      name={path.slice(path.lastIndexOf("/") + 1)}
      what={what}
      onMerge={() => reload(true)}
      onTakeTheirs={() => reload(false)}
      onKeepMine={() => void order(session, { case: "saveDocuments", value: { documents: [path], overwrite: true } })}
      onDismiss={() => (isGone ? setKnowsItIsGone(true) : setSeen(takenOver))}
      isWatching={!mayOrder}
    />
  );
}
