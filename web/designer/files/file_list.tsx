// The files of a folder of the project, as the server lists them.
import { useEffect, useState } from "react";
import { ListBox, ListBoxItem } from "react-aria-components";
import { ancestors, nameOf } from "../../console/start/paths.ts";
import { Button } from "../../console/ui/controls.tsx";
import { Icon } from "../../console/ui/icons.tsx";
import type { FileList_Entry } from "../../core/protocol.ts";
import { useDesigner } from "../use.ts";

interface FileListProps {
  folder: string;
  onFolder: (folder: string) => void;
  chosen: string;
  onChoose: (path: string) => void;
  /** Enter or a double click. */
  onOpen: (path: string) => void;
}

export function FileList({ folder, onFolder, chosen, onChoose, onOpen }: FileListProps) {
  const designer = useDesigner();
  const [entries, setEntries] = useState<readonly FileList_Entry[] | null>(null);
  const [problem, setProblem] = useState("");
  useEffect(() => {
    let isCurrent = true;
    setEntries(null);
    void designer.link.ask({ case: "listFiles", value: { folder } }).then((answer) => {
      if (!isCurrent) return;
      setProblem(answer.ok ? "" : answer.error);
      setEntries(answer.result.case === "files" ? answer.result.value.entries.filter(isOurs) : []);
    });
    return () => {
      isCurrent = false;
    };
  }, [designer, folder]);
  const act = (path: string) => {
    const entry = entries?.find((one) => one.path === path);
    if (entry?.isFolder) onFolder(entry.path);
    else if (entry) onOpen(path);
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
        renderEmptyState={() => <p className="empty small">{entries ? "No configurations here." : "Reading…"}</p>}
        items={(entries ?? []).map((entry) => ({ id: entry.path, entry }))}
      >
        {({ entry }) => (
          <ListBoxItem id={entry.path} className="file" textValue={nameOf(entry.path)}>
            <Icon name={entry.isFolder ? "folder" : "file"} />
            <span className="grow ellipsis">{nameOf(entry.path)}</span>
          </ListBoxItem>
        )}
      </ListBox>
    </div>
  );
}

function isOurs(entry: FileList_Entry): boolean {
  return entry.isFolder || entry.path.endsWith(".cdl");
}
