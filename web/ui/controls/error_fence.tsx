import { Component, type ReactNode } from "react";
import { Button } from "./controls.tsx";

/** A panel that fails says so, and everything around it goes on. */
export class ErrorFence extends Component<{ name: string; children: ReactNode }, { error: Error | null }> {
  override state: { error: Error | null } = { error: null };

  static getDerivedStateFromError(error: Error) {
    return { error };
  }

  override render() {
    const { error } = this.state;
    if (!error) return this.props.children;
    return (
      <div className="empty" role="alert">
        <p>{this.props.name} failed, all else goes on.</p>
        <p className="mono small">{error.message}</p>
        <Button onPress={() => this.setState({ error: null })}>Try again</Button>
      </div>
    );
  }
}
