import { Component, type ReactNode } from "react";
import { Button } from "../../ui/controls/controls.tsx";

interface FenceProps {
  name: string;
  children: ReactNode;
}

/** An error in one part leaves the others standing. */
export class Fence extends Component<FenceProps, { error: Error | null }> {
  override state: { error: Error | null } = { error: null };

  static getDerivedStateFromError(error: Error) {
    return { error };
  }

  override render(): ReactNode {
    const { error } = this.state;
    if (!error) return this.props.children;
    return (
      <div className="empty" role="alert">
        <p>{this.props.name} had an error and is not shown.</p>
        <p className="small mono">{error.message}</p>
        <Button onPress={() => this.setState({ error: null })}>Show it again</Button>
      </div>
    );
  }
}
