// Menus, popovers and dialogs.
import { type ReactNode, useId, useRef } from "react";
import {
  Dialog,
  DialogTrigger,
  Header,
  Heading,
  Menu,
  MenuItem,
  MenuSection,
  MenuTrigger,
  Modal,
  ModalOverlay,
  Popover,
  Separator,
} from "react-aria-components";
import { IconButton } from "./controls.tsx";
import { Icon, type IconName } from "./icons.tsx";

export interface MenuEntry {
  id: string;
  label: string;
  icon?: IconName;
  shortcut?: string;
  /** Under the label. */
  detail?: string;
  isDisabled?: boolean;
  run: () => void;
}

export interface MenuGroup {
  title?: string;
  entries: readonly MenuEntry[];
}

/** `trigger` is a button. */
export function MenuButton({
  trigger,
  label,
  groups,
}: {
  trigger: ReactNode;
  label: string;
  groups: readonly MenuGroup[];
}) {
  return (
    <MenuTrigger>
      {trigger}
      <Popover className="popover" offset={4}>
        <MenuOf label={label} groups={groups} />
      </Popover>
    </MenuTrigger>
  );
}

interface MenuAtProps {
  /** The button that it was opened with. */
  at: Element;
  label: string;
  groups: readonly MenuGroup[];
  onClose: () => void;
}

/** An open menu, one for the buttons of many rows: a menu of its own for each would cost more than the row. */
export function MenuAt({ at, label, groups, onClose }: MenuAtProps) {
  const trigger = useRef(at);
  trigger.current = at;
  return (
    <Popover
      className="popover"
      offset={4}
      aria-label={label}
      trigger="MenuTrigger"
      triggerRef={trigger}
      isOpen
      onOpenChange={(isOpen) => !isOpen && onClose()}
    >
      <MenuOf label={label} groups={groups} onClose={onClose} />
    </Popover>
  );
}

interface MenuOfProps {
  label: string;
  groups: readonly MenuGroup[];
  /** It is opened by somebody else than its trigger. */
  onClose?: () => void;
}

function MenuOf({ label, groups, onClose }: MenuOfProps) {
  return (
    <Menu className="menu" aria-label={label} {...(onClose ? { onClose, autoFocus: "first" } : {})}>
      {groups.flatMap((group, i) => [
        ...(i > 0 ? [<Separator key={`s${i}`} className="menu-separator" />] : []),
        <MenuSection key={`g${i}`} aria-label={group.title ?? label}>
          {group.title && <Header className="menu-header">{group.title}</Header>}
          {group.entries.map((entry) => (
            <MenuItem
              key={entry.id}
              id={entry.id}
              className="menu-item"
              textValue={entry.label}
              isDisabled={entry.isDisabled ?? false}
              onAction={entry.run}
            >
              {entry.icon && <Icon name={entry.icon} />}
              <span className="texts">
                <span>{entry.label}</span>
                {entry.detail && <span className="small muted ellipsis">{entry.detail}</span>}
              </span>
              {entry.shortcut && (
                <span className="tail">
                  <kbd>{entry.shortcut}</kbd>
                </span>
              )}
            </MenuItem>
          ))}
        </MenuSection>,
      ])}
    </Menu>
  );
}

export function PopoverButton({
  trigger,
  label,
  children,
}: {
  trigger: ReactNode;
  label: string;
  children: ReactNode;
}) {
  const name = useId();
  return (
    <DialogTrigger>
      {trigger}
      {/* Without a Dialog in it the popover is one itself, hidden buttons for closing it included. */}
      {/* The trigger would name it by what it shows at the moment, and that name would come before the label. */}
      <Popover className="popover" offset={4} aria-labelledby={name}>
        <span id={name} className="hidden-text">
          {label}
        </span>
        <div className="content">{children}</div>
      </Popover>
    </DialogTrigger>
  );
}

interface DialogBoxProps {
  title: string;
  onClose: () => void;
  children: ReactNode;
  footer?: ReactNode;
  width?: number;
}

export function DialogBox({ title, onClose, children, footer, width }: DialogBoxProps) {
  return (
    <ModalOverlay className="scrim" isOpen isDismissable onOpenChange={(open) => !open && onClose()}>
      <Modal className="dialog" {...(width ? { style: { width: `min(${width}px, 94vw)` } } : {})}>
        <Dialog>
          <div className="dialog-head">
            <Heading slot="title" level={2}>
              {title}
            </Heading>
            <IconButton icon="close" label="Close" onPress={onClose} />
          </div>
          {/* biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls has to be reached by keyboard */}
          <div className="body" tabIndex={0}>
            {children}
          </div>
          {footer && <footer>{footer}</footer>}
        </Dialog>
      </Modal>
    </ModalOverlay>
  );
}
