// The files of a folder of the project, as the server lists them.
import { useEffect, useState } from "react";
import { ListBox, ListBoxItem } from "react-aria-components";
import type { FileList_Entry } from "../../core/protocol.ts";
import { Button } from "../controls/controls.tsx";
import { Icon } from "../controls/icons.tsx";
import { ancestors, nameOf } from "./paths.ts";

interface FileListProps {
  folder: string;
  onFolder: (folder: string) => void;
  chosen: string;
  onChoose: (path: string) => void;
  /** Enter or a double click. */
  onOpen: (path: string) => void;
  isSelectable: (entry: FileList_Entry) => boolean;
  /** What is in a folder. The same function as long as nothing else is to be read. */
  list: (folder: string) => Promise<FolderListing>;
}

export interface FolderListing {
  entries: readonly FileList_Entry[];
  /** Why there are none; empty: all is well. */
  problem: string;
}

export function FileList({ folder, onFolder, chosen, onChoose, onOpen, isSelectable, list }: FileListProps) {
  const [entries, setEntries] = useState<readonly FileList_Entry[] | null>(null);
  const [problem, setProblem] = useState("");
  useEffect(() => {
    let isCurrent = true;
    setEntries(null);
    void list(folder).then((listed) => {
      if (!isCurrent) return;
      setProblem(listed.problem);
      setEntries(listed.entries);
    });
    return () => {
      isCurrent = false;
    };
  }, [list, folder]);
  const files = (entries ?? []).filter((entry) => !entry.isFolder);
  const hasKinds = new Set(files.map((entry) => entry.kind)).size > 1;
  const act = (path: string) => {
    const entry = entries?.find((one) => one.path === path);
    if (entry?.isFolder) onFolder(entry.path);
    else if (entry && isSelectable(entry)) onOpen(path);
  };
  return (
    <div className="rows" style={{ gap: 6 }}>
      <nav className="columns" aria-label="Folder" style={{ gap: 2 }}>
        {ancestors(folder).map((path) => (
          <Button key={path} tone="quiet" onPress={() => onFolder(path)} isDisabled={path === folder}>
            {path === "" ? "Project" : nameOf(path)}
          </Button>
        ))}
      </nav>
      {problem && <p className="problem">{problem}</p>}
      <ListBox
        aria-label="Files"
        className="files"
        selectionMode="single"
        selectedKeys={chosen ? [chosen] : []}
        onSelectionChange={(keys) => {
          const [key] = keys === "all" ? [] : [...keys];
          const entry = entries?.find((one) => one.path === key);
          if (entry?.isFolder) onFolder(entry.path);
          else if (entry) onChoose(entry.path);
        }}
        onAction={(key) => act(String(key))}
        disabledKeys={files.filter((entry) => !isSelectable(entry)).map((entry) => entry.path)}
        renderEmptyState={() => <p className="empty small">{entries ? "Nothing here." : "Reading…"}</p>}
        items={(entries ?? []).map((entry) => ({ id: entry.path, entry }))}
      >
        {({ entry }) => (
          <ListBoxItem id={entry.path} className="file" textValue={nameOf(entry.path)}>
            <Icon name={entry.isFolder ? "folder" : entry.kind === "overlay" ? "map" : "file"} />
            <span className="grow ellipsis">{nameOf(entry.path)}</span>
            {hasKinds && !entry.isFolder && entry.kind !== "other" && <span className="small muted">{entry.kind}</span>}
          </ListBoxItem>
        )}
      </ListBox>
    </div>
  );
}
