Object.defineProperty(exports, Symbol.toStringTag, { value: "Module" });
// \0rolldown/runtime.js
var __create = Object.create;
var __defProp = Object.defineProperty;
var __getOwnPropDesc = Object.getOwnPropertyDescriptor;
var __getOwnPropNames = Object.getOwnPropertyNames;
var __getProtoOf = Object.getPrototypeOf;
var __hasOwnProp = Object.prototype.hasOwnProperty;
var __esmMin = (fn, res, err) => () => {
	if (err) throw err[0];
	try {
		return fn && (res = fn(fn = 0)), res;
	} catch (e) {
		throw err = [e], e;
	}
};
var __commonJSMin = (cb, mod) => () => (mod || (cb((mod = { exports: {} }).exports, mod, mod.exports), cb = null), mod.exports);
var __exportAll = (all, no_symbols) => {
	let target = {};
	for (var name in all) __defProp(target, name, {
		get: all[name],
		enumerable: true
	});
	if (!no_symbols) __defProp(target, Symbol.toStringTag, { value: "Module" });
	return target;
};
var __copyProps = (to, from, except, desc) => {
	if (from && typeof from === "object" || typeof from === "function") for (var keys = __getOwnPropNames(from), i = 0, n = keys.length, key; i < n; i++) {
		key = keys[i];
		if (!__hasOwnProp.call(to, key) && key !== except) __defProp(to, key, {
			get: ((k) => from[k]).bind(null, key),
			enumerable: !(desc = __getOwnPropDesc(from, key)) || desc.enumerable
		});
	}
	return to;
};
var __toESM = (mod, isNodeMode, target) => (target = mod != null ? __create(__getProtoOf(mod)) : {}, __copyProps(isNodeMode || !mod || !mod.__esModule || !__hasOwnProp.call(mod, "default") ? __defProp(target, "default", {
	value: mod,
	enumerable: true
}) : target, mod));
var __toCommonJS = (mod) => __hasOwnProp.call(mod, "module.exports") ? mod["module.exports"] : __copyProps(__defProp({}, "__esModule", { value: true }), mod);
let node_os = require("node:os");
node_os = __toESM(node_os);
let vscode = require("vscode");
vscode = __toESM(vscode);
let node_path = require("node:path");
node_path = __toESM(node_path);
// node_modules/vscode-languageclient/lib/common/utils/is.js
var require_is$2 = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.boolean = boolean;
	exports.string = string;
	exports.number = number;
	exports.error = error;
	exports.func = func;
	exports.array = array;
	exports.stringArray = stringArray;
	exports.typedArray = typedArray;
	exports.thenable = thenable;
	exports.asPromise = asPromise;
	function boolean(value) {
		return value === true || value === false;
	}
	function string(value) {
		return typeof value === "string" || value instanceof String;
	}
	function number(value) {
		return typeof value === "number" || value instanceof Number;
	}
	function error(value) {
		return value instanceof Error;
	}
	function func(value) {
		return typeof value === "function";
	}
	function array(value) {
		return Array.isArray(value);
	}
	function stringArray(value) {
		return array(value) && value.every((elem) => string(elem));
	}
	function typedArray(value, check) {
		return Array.isArray(value) && value.every(check);
	}
	function thenable(value) {
		return value && func(value.then);
	}
	function asPromise(value) {
		if (value instanceof Promise) return value;
		else if (thenable(value)) return new Promise((resolve, reject) => {
			value.then((resolved) => resolve(resolved), (error) => reject(error));
		});
		else return Promise.resolve(value);
	}
}));
// node_modules/vscode-jsonrpc/lib/common/is.js
var require_is$1 = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.boolean = boolean;
	exports.string = string;
	exports.number = number;
	exports.error = error;
	exports.func = func;
	exports.array = array;
	exports.stringArray = stringArray;
	function boolean(value) {
		return value === true || value === false;
	}
	function string(value) {
		return typeof value === "string" || value instanceof String;
	}
	function number(value) {
		return typeof value === "number" || value instanceof Number;
	}
	function error(value) {
		return value instanceof Error;
	}
	function func(value) {
		return typeof value === "function";
	}
	function array(value) {
		return Array.isArray(value);
	}
	function stringArray(value) {
		return array(value) && value.every((elem) => string(elem));
	}
}));
// node_modules/vscode-jsonrpc/lib/common/messages.js
var require_messages$1 = /* @__PURE__ */ __commonJSMin(((exports, module, this$39) => {
	var __createBinding = this$39 && this$39.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$39 && this$39.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$39 && this$39.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.Message = exports.NotificationType9 = exports.NotificationType8 = exports.NotificationType7 = exports.NotificationType6 = exports.NotificationType5 = exports.NotificationType4 = exports.NotificationType3 = exports.NotificationType2 = exports.NotificationType1 = exports.NotificationType0 = exports.NotificationType = exports.RequestType9 = exports.RequestType8 = exports.RequestType7 = exports.RequestType6 = exports.RequestType5 = exports.RequestType4 = exports.RequestType3 = exports.RequestType2 = exports.RequestType1 = exports.RequestType = exports.RequestType0 = exports.AbstractMessageSignature = exports.ParameterStructures = exports.ResponseError = exports.ErrorCodes = void 0;
	var is = __importStar(require_is$1());
	/**
	* Predefined error codes.
	*/
	var ErrorCodes;
	(function(ErrorCodes) {
		ErrorCodes.ParseError = -32700;
		ErrorCodes.InvalidRequest = -32600;
		ErrorCodes.MethodNotFound = -32601;
		ErrorCodes.InvalidParams = -32602;
		ErrorCodes.InternalError = -32603;
		/**
		* This is the start range of JSON RPC reserved error codes.
		* It doesn't denote a real error code. No application error codes should
		* be defined between the start and end range. For backwards
		* compatibility the `ServerNotInitialized` and the `UnknownErrorCode`
		* are left in the range.
		*
		* @since 3.16.0
		*/
		ErrorCodes.jsonrpcReservedErrorRangeStart = -32099;
		/** @deprecated use  jsonrpcReservedErrorRangeStart */
		ErrorCodes.serverErrorStart = -32099;
		/**
		* An error occurred when write a message to the transport layer.
		*/
		ErrorCodes.MessageWriteError = -32099;
		/**
		* An error occurred when reading a message from the transport layer.
		*/
		ErrorCodes.MessageReadError = -32098;
		/**
		* The connection got disposed or lost and all pending responses got
		* rejected.
		*/
		ErrorCodes.PendingResponseRejected = -32097;
		/**
		* The connection is inactive and a use of it failed.
		*/
		ErrorCodes.ConnectionInactive = -32096;
		/**
		* Error code indicating that a server received a notification or
		* request before the server has received the `initialize` request.
		*/
		ErrorCodes.ServerNotInitialized = -32002;
		ErrorCodes.UnknownErrorCode = -32001;
		/**
		* This is the end range of JSON RPC reserved error codes.
		* It doesn't denote a real error code.
		*
		* @since 3.16.0
		*/
		ErrorCodes.jsonrpcReservedErrorRangeEnd = -32e3;
		/** @deprecated use  jsonrpcReservedErrorRangeEnd */
		ErrorCodes.serverErrorEnd = -32e3;
	})(ErrorCodes || (exports.ErrorCodes = ErrorCodes = {}));
	exports.ResponseError = class ResponseError extends Error {
		code;
		data;
		constructor(code, message, data) {
			super(message);
			this.code = is.number(code) ? code : ErrorCodes.UnknownErrorCode;
			this.data = data;
			Object.setPrototypeOf(this, ResponseError.prototype);
		}
		toJson() {
			const result = {
				code: this.code,
				message: this.message
			};
			if (this.data !== void 0) result.data = this.data;
			return result;
		}
	};
	var ParameterStructures = class ParameterStructures {
		kind;
		/**
		* The parameter structure is automatically inferred on the number of parameters
		* and the parameter type in case of a single param.
		*/
		static auto = new ParameterStructures("auto");
		/**
		* Forces `byPosition` parameter structure. This is useful if you have a single
		* parameter which has a literal type.
		*/
		static byPosition = new ParameterStructures("byPosition");
		/**
		* Forces `byName` parameter structure. This is only useful when having a single
		* parameter. The library will report errors if used with a different number of
		* parameters.
		*/
		static byName = new ParameterStructures("byName");
		constructor(kind) {
			this.kind = kind;
		}
		static is(value) {
			return value === ParameterStructures.auto || value === ParameterStructures.byName || value === ParameterStructures.byPosition;
		}
		toString() {
			return this.kind;
		}
	};
	exports.ParameterStructures = ParameterStructures;
	/**
	* An abstract implementation of a MessageType.
	*/
	var AbstractMessageSignature = class {
		method;
		numberOfParams;
		constructor(method, numberOfParams) {
			this.method = method;
			this.numberOfParams = numberOfParams;
		}
		get parameterStructures() {
			return ParameterStructures.auto;
		}
	};
	exports.AbstractMessageSignature = AbstractMessageSignature;
	/**
	* Classes to type request response pairs
	*/
	var RequestType0 = class extends AbstractMessageSignature {
		/**
		* Clients must not use this property. It is here to ensure correct typing.
		*/
		_;
		constructor(method) {
			super(method, 0);
		}
	};
	exports.RequestType0 = RequestType0;
	var RequestType = class extends AbstractMessageSignature {
		_parameterStructures;
		/**
		* Clients must not use this property. It is here to ensure correct typing.
		*/
		_;
		constructor(method, _parameterStructures = ParameterStructures.auto) {
			super(method, 1);
			this._parameterStructures = _parameterStructures;
		}
		get parameterStructures() {
			return this._parameterStructures;
		}
	};
	exports.RequestType = RequestType;
	var RequestType1 = class extends AbstractMessageSignature {
		_parameterStructures;
		/**
		* Clients must not use this property. It is here to ensure correct typing.
		*/
		_;
		constructor(method, _parameterStructures = ParameterStructures.auto) {
			super(method, 1);
			this._parameterStructures = _parameterStructures;
		}
		get parameterStructures() {
			return this._parameterStructures;
		}
	};
	exports.RequestType1 = RequestType1;
	var RequestType2 = class extends AbstractMessageSignature {
		/**
		* Clients must not use this property. It is here to ensure correct typing.
		*/
		_;
		constructor(method) {
			super(method, 2);
		}
	};
	exports.RequestType2 = RequestType2;
	var RequestType3 = class extends AbstractMessageSignature {
		/**
		* Clients must not use this property. It is here to ensure correct typing.
		*/
		_;
		constructor(method) {
			super(method, 3);
		}
	};
	exports.RequestType3 = RequestType3;
	var RequestType4 = class extends AbstractMessageSignature {
		/**
		* Clients must not use this property. It is here to ensure correct typing.
		*/
		_;
		constructor(method) {
			super(method, 4);
		}
	};
	exports.RequestType4 = RequestType4;
	var RequestType5 = class extends AbstractMessageSignature {
		/**
		* Clients must not use this property. It is here to ensure correct typing.
		*/
		_;
		constructor(method) {
			super(method, 5);
		}
	};
	exports.RequestType5 = RequestType5;
	var RequestType6 = class extends AbstractMessageSignature {
		/**
		* Clients must not use this property. It is here to ensure correct typing.
		*/
		_;
		constructor(method) {
			super(method, 6);
		}
	};
	exports.RequestType6 = RequestType6;
	var RequestType7 = class extends AbstractMessageSignature {
		/**
		* Clients must not use this property. It is here to ensure correct typing.
		*/
		_;
		constructor(method) {
			super(method, 7);
		}
	};
	exports.RequestType7 = RequestType7;
	var RequestType8 = class extends AbstractMessageSignature {
		/**
		* Clients must not use this property. It is here to ensure correct typing.
		*/
		_;
		constructor(method) {
			super(method, 8);
		}
	};
	exports.RequestType8 = RequestType8;
	var RequestType9 = class extends AbstractMessageSignature {
		/**
		* Clients must not use this property. It is here to ensure correct typing.
		*/
		_;
		constructor(method) {
			super(method, 9);
		}
	};
	exports.RequestType9 = RequestType9;
	var NotificationType = class extends AbstractMessageSignature {
		_parameterStructures;
		/**
		* Clients must not use this property. It is here to ensure correct typing.
		*/
		_;
		constructor(method, _parameterStructures = ParameterStructures.auto) {
			super(method, 1);
			this._parameterStructures = _parameterStructures;
		}
		get parameterStructures() {
			return this._parameterStructures;
		}
	};
	exports.NotificationType = NotificationType;
	var NotificationType0 = class extends AbstractMessageSignature {
		/**
		* Clients must not use this property. It is here to ensure correct typing.
		*/
		_;
		constructor(method) {
			super(method, 0);
		}
	};
	exports.NotificationType0 = NotificationType0;
	var NotificationType1 = class extends AbstractMessageSignature {
		_parameterStructures;
		/**
		* Clients must not use this property. It is here to ensure correct typing.
		*/
		_;
		constructor(method, _parameterStructures = ParameterStructures.auto) {
			super(method, 1);
			this._parameterStructures = _parameterStructures;
		}
		get parameterStructures() {
			return this._parameterStructures;
		}
	};
	exports.NotificationType1 = NotificationType1;
	var NotificationType2 = class extends AbstractMessageSignature {
		/**
		* Clients must not use this property. It is here to ensure correct typing.
		*/
		_;
		constructor(method) {
			super(method, 2);
		}
	};
	exports.NotificationType2 = NotificationType2;
	var NotificationType3 = class extends AbstractMessageSignature {
		/**
		* Clients must not use this property. It is here to ensure correct typing.
		*/
		_;
		constructor(method) {
			super(method, 3);
		}
	};
	exports.NotificationType3 = NotificationType3;
	var NotificationType4 = class extends AbstractMessageSignature {
		/**
		* Clients must not use this property. It is here to ensure correct typing.
		*/
		_;
		constructor(method) {
			super(method, 4);
		}
	};
	exports.NotificationType4 = NotificationType4;
	var NotificationType5 = class extends AbstractMessageSignature {
		/**
		* Clients must not use this property. It is here to ensure correct typing.
		*/
		_;
		constructor(method) {
			super(method, 5);
		}
	};
	exports.NotificationType5 = NotificationType5;
	var NotificationType6 = class extends AbstractMessageSignature {
		/**
		* Clients must not use this property. It is here to ensure correct typing.
		*/
		_;
		constructor(method) {
			super(method, 6);
		}
	};
	exports.NotificationType6 = NotificationType6;
	var NotificationType7 = class extends AbstractMessageSignature {
		/**
		* Clients must not use this property. It is here to ensure correct typing.
		*/
		_;
		constructor(method) {
			super(method, 7);
		}
	};
	exports.NotificationType7 = NotificationType7;
	var NotificationType8 = class extends AbstractMessageSignature {
		/**
		* Clients must not use this property. It is here to ensure correct typing.
		*/
		_;
		constructor(method) {
			super(method, 8);
		}
	};
	exports.NotificationType8 = NotificationType8;
	var NotificationType9 = class extends AbstractMessageSignature {
		/**
		* Clients must not use this property. It is here to ensure correct typing.
		*/
		_;
		constructor(method) {
			super(method, 9);
		}
	};
	exports.NotificationType9 = NotificationType9;
	var Message;
	(function(Message) {
		/**
		* Tests if the given message is a request message
		*/
		function isRequest(message) {
			const candidate = message;
			return candidate && is.string(candidate.method) && (is.string(candidate.id) || is.number(candidate.id));
		}
		Message.isRequest = isRequest;
		/**
		* Tests if the given message is a notification message
		*/
		function isNotification(message) {
			const candidate = message;
			return candidate && is.string(candidate.method) && message.id === void 0;
		}
		Message.isNotification = isNotification;
		/**
		* Tests if the given message is a response message
		*/
		function isResponse(message) {
			const candidate = message;
			return candidate && (candidate.result !== void 0 || !!candidate.error) && (is.string(candidate.id) || is.number(candidate.id) || candidate.id === null);
		}
		Message.isResponse = isResponse;
	})(Message || (exports.Message = Message = {}));
}));
// node_modules/vscode-jsonrpc/lib/common/linkedMap.js
var require_linkedMap = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.LRUCache = exports.LinkedMap = exports.Touch = void 0;
	var Touch;
	(function(Touch) {
		Touch.None = 0;
		Touch.First = 1;
		Touch.AsOld = Touch.First;
		Touch.Last = 2;
		Touch.AsNew = Touch.Last;
	})(Touch || (exports.Touch = Touch = {}));
	var LinkedMap = class {
		[Symbol.toStringTag] = "LinkedMap";
		_map;
		_head;
		_tail;
		_size;
		_state;
		constructor() {
			this._map = /* @__PURE__ */ new Map();
			this._head = void 0;
			this._tail = void 0;
			this._size = 0;
			this._state = 0;
		}
		clear() {
			this._map.clear();
			this._head = void 0;
			this._tail = void 0;
			this._size = 0;
			this._state++;
		}
		isEmpty() {
			return !this._head && !this._tail;
		}
		get size() {
			return this._size;
		}
		get first() {
			return this._head?.value;
		}
		get last() {
			return this._tail?.value;
		}
		before(key) {
			const item = this._map.get(key);
			return item ? item.previous?.value : void 0;
		}
		after(key) {
			const item = this._map.get(key);
			return item ? item.next?.value : void 0;
		}
		has(key) {
			return this._map.has(key);
		}
		get(key, touch = Touch.None) {
			const item = this._map.get(key);
			if (!item) return;
			if (touch !== Touch.None) this.touch(item, touch);
			return item.value;
		}
		set(key, value, touch = Touch.None) {
			let item = this._map.get(key);
			if (item) {
				item.value = value;
				if (touch !== Touch.None) this.touch(item, touch);
			} else {
				item = {
					key,
					value,
					next: void 0,
					previous: void 0
				};
				switch (touch) {
					case Touch.None:
						this.addItemLast(item);
						break;
					case Touch.First:
						this.addItemFirst(item);
						break;
					case Touch.Last:
						this.addItemLast(item);
						break;
					default: this.addItemLast(item);
				}
				this._map.set(key, item);
				this._size++;
			}
			return this;
		}
		delete(key) {
			return !!this.remove(key);
		}
		remove(key) {
			const item = this._map.get(key);
			if (!item) return;
			this._map.delete(key);
			this.removeItem(item);
			this._size--;
			return item.value;
		}
		shift() {
			if (!this._head && !this._tail) return;
			if (!this._head || !this._tail) throw new Error("Invalid list");
			const item = this._head;
			this._map.delete(item.key);
			this.removeItem(item);
			this._size--;
			return item.value;
		}
		forEach(callbackfn, thisArg) {
			const state = this._state;
			let current = this._head;
			while (current) {
				if (thisArg) callbackfn.bind(thisArg)(current.value, current.key, this);
				else callbackfn(current.value, current.key, this);
				if (this._state !== state) throw new Error(`LinkedMap got modified during iteration.`);
				current = current.next;
			}
		}
		keys() {
			const state = this._state;
			let current = this._head;
			const iterator = {
				[Symbol.iterator]: () => {
					return iterator;
				},
				next: () => {
					if (this._state !== state) throw new Error(`LinkedMap got modified during iteration.`);
					if (current) {
						const result = {
							value: current.key,
							done: false
						};
						current = current.next;
						return result;
					} else return {
						value: void 0,
						done: true
					};
				}
			};
			return iterator;
		}
		values() {
			const state = this._state;
			let current = this._head;
			const iterator = {
				[Symbol.iterator]: () => {
					return iterator;
				},
				next: () => {
					if (this._state !== state) throw new Error(`LinkedMap got modified during iteration.`);
					if (current) {
						const result = {
							value: current.value,
							done: false
						};
						current = current.next;
						return result;
					} else return {
						value: void 0,
						done: true
					};
				}
			};
			return iterator;
		}
		entries() {
			const state = this._state;
			let current = this._head;
			const iterator = {
				[Symbol.iterator]: () => {
					return iterator;
				},
				next: () => {
					if (this._state !== state) throw new Error(`LinkedMap got modified during iteration.`);
					if (current) {
						const result = {
							value: [current.key, current.value],
							done: false
						};
						current = current.next;
						return result;
					} else return {
						value: void 0,
						done: true
					};
				}
			};
			return iterator;
		}
		[Symbol.iterator]() {
			return this.entries();
		}
		trimOld(newSize) {
			if (newSize >= this.size) return;
			if (newSize === 0) {
				this.clear();
				return;
			}
			let current = this._head;
			let currentSize = this.size;
			while (current && currentSize > newSize) {
				this._map.delete(current.key);
				current = current.next;
				currentSize--;
			}
			this._head = current;
			this._size = currentSize;
			if (current) current.previous = void 0;
			this._state++;
		}
		addItemFirst(item) {
			if (!this._head && !this._tail) this._tail = item;
			else if (!this._head) throw new Error("Invalid list");
			else {
				item.next = this._head;
				this._head.previous = item;
			}
			this._head = item;
			this._state++;
		}
		addItemLast(item) {
			if (!this._head && !this._tail) this._head = item;
			else if (!this._tail) throw new Error("Invalid list");
			else {
				item.previous = this._tail;
				this._tail.next = item;
			}
			this._tail = item;
			this._state++;
		}
		removeItem(item) {
			if (item === this._head && item === this._tail) {
				this._head = void 0;
				this._tail = void 0;
			} else if (item === this._head) {
				if (!item.next) throw new Error("Invalid list");
				item.next.previous = void 0;
				this._head = item.next;
			} else if (item === this._tail) {
				if (!item.previous) throw new Error("Invalid list");
				item.previous.next = void 0;
				this._tail = item.previous;
			} else {
				const next = item.next;
				const previous = item.previous;
				if (!next || !previous) throw new Error("Invalid list");
				next.previous = previous;
				previous.next = next;
			}
			item.next = void 0;
			item.previous = void 0;
			this._state++;
		}
		touch(item, touch) {
			if (!this._head || !this._tail) throw new Error("Invalid list");
			if (touch !== Touch.First && touch !== Touch.Last) return;
			if (touch === Touch.First) {
				if (item === this._head) return;
				const next = item.next;
				const previous = item.previous;
				if (item === this._tail) {
					previous.next = void 0;
					this._tail = previous;
				} else {
					next.previous = previous;
					previous.next = next;
				}
				item.previous = void 0;
				item.next = this._head;
				this._head.previous = item;
				this._head = item;
				this._state++;
			} else if (touch === Touch.Last) {
				if (item === this._tail) return;
				const next = item.next;
				const previous = item.previous;
				if (item === this._head) {
					next.previous = void 0;
					this._head = next;
				} else {
					next.previous = previous;
					previous.next = next;
				}
				item.next = void 0;
				item.previous = this._tail;
				this._tail.next = item;
				this._tail = item;
				this._state++;
			}
		}
		toJSON() {
			const data = [];
			this.forEach((value, key) => {
				data.push([key, value]);
			});
			return data;
		}
		fromJSON(data) {
			this.clear();
			for (const [key, value] of data) this.set(key, value);
		}
	};
	exports.LinkedMap = LinkedMap;
	var LRUCache = class extends LinkedMap {
		_limit;
		_ratio;
		constructor(limit, ratio = 1) {
			super();
			this._limit = limit;
			this._ratio = Math.min(Math.max(0, ratio), 1);
		}
		get limit() {
			return this._limit;
		}
		set limit(limit) {
			this._limit = limit;
			this.checkTrim();
		}
		get ratio() {
			return this._ratio;
		}
		set ratio(ratio) {
			this._ratio = Math.min(Math.max(0, ratio), 1);
			this.checkTrim();
		}
		get(key, touch = Touch.AsNew) {
			return super.get(key, touch);
		}
		peek(key) {
			return super.get(key, Touch.None);
		}
		set(key, value) {
			super.set(key, value, Touch.Last);
			this.checkTrim();
			return this;
		}
		checkTrim() {
			if (this.size > this._limit) this.trimOld(Math.round(this._limit * this._ratio));
		}
	};
	exports.LRUCache = LRUCache;
}));
// node_modules/vscode-jsonrpc/lib/common/disposable.js
var require_disposable = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.Disposable = void 0;
	var Disposable;
	(function(Disposable) {
		function create(func) {
			return { dispose: func };
		}
		Disposable.create = create;
	})(Disposable || (exports.Disposable = Disposable = {}));
}));
// node_modules/vscode-jsonrpc/lib/common/ral.js
var require_ral = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	var _ral;
	function RAL() {
		if (_ral === void 0) throw new Error(`No runtime abstraction layer installed`);
		return _ral;
	}
	(function(RAL) {
		function install(ral) {
			if (ral === void 0) throw new Error(`No runtime abstraction layer provided`);
			_ral = ral;
		}
		RAL.install = install;
	})(RAL || (RAL = {}));
	exports.default = RAL;
}));
// node_modules/vscode-jsonrpc/lib/common/events.js
var require_events = /* @__PURE__ */ __commonJSMin(((exports, module, this$38) => {
	var __importDefault = this$38 && this$38.__importDefault || function(mod) {
		return mod && mod.__esModule ? mod : { "default": mod };
	};
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.Emitter = exports.Event = void 0;
	var ral_1 = __importDefault(require_ral());
	var Event;
	(function(Event) {
		const _disposable = { dispose() {} };
		Event.None = function() {
			return _disposable;
		};
	})(Event || (exports.Event = Event = {}));
	var CallbackList = class {
		_callbacks;
		_contexts;
		add(callback, context = null, bucket) {
			if (!this._callbacks) {
				this._callbacks = [];
				this._contexts = [];
			}
			this._callbacks.push(callback);
			this._contexts.push(context);
			if (Array.isArray(bucket)) bucket.push({ dispose: () => this.remove(callback, context) });
		}
		remove(callback, context = null) {
			if (!this._callbacks) return;
			let foundCallbackWithDifferentContext = false;
			for (let i = 0, len = this._callbacks.length; i < len; i++) if (this._callbacks[i] === callback) {
				if (this._contexts[i] === context) {
					this._callbacks.splice(i, 1);
					this._contexts.splice(i, 1);
					return;
				} else foundCallbackWithDifferentContext = true;
			}
			if (foundCallbackWithDifferentContext) throw new Error("When adding a listener with a context, you should remove it with the same context");
		}
		invoke(...args) {
			if (!this._callbacks) return [];
			const ret = [], callbacks = this._callbacks.slice(0), contexts = this._contexts.slice(0);
			for (let i = 0, len = callbacks.length; i < len; i++) try {
				ret.push(callbacks[i].apply(contexts[i], args));
			} catch (e) {
				(0, ral_1.default)().console.error(e);
			}
			return ret;
		}
		isEmpty() {
			return !this._callbacks || this._callbacks.length === 0;
		}
		dispose() {
			this._callbacks = void 0;
			this._contexts = void 0;
		}
	};
	exports.Emitter = class Emitter {
		_options;
		static _noop = function() {};
		_event;
		_callbacks;
		constructor(_options) {
			this._options = _options;
		}
		/**
		* For the public to allow to subscribe
		* to events from this Emitter
		*/
		get event() {
			if (!this._event) this._event = (listener, thisArgs, disposables) => {
				if (!this._callbacks) this._callbacks = new CallbackList();
				if (this._options && this._options.onFirstListenerAdd && this._callbacks.isEmpty()) this._options.onFirstListenerAdd(this);
				this._callbacks.add(listener, thisArgs);
				const result = { dispose: () => {
					if (!this._callbacks) return;
					this._callbacks.remove(listener, thisArgs);
					result.dispose = Emitter._noop;
					if (this._options && this._options.onLastListenerRemove && this._callbacks.isEmpty()) this._options.onLastListenerRemove(this);
				} };
				if (Array.isArray(disposables)) disposables.push(result);
				return result;
			};
			return this._event;
		}
		/**
		* To be kept private to fire an event to
		* subscribers
		*/
		fire(event) {
			if (this._callbacks) this._callbacks.invoke.call(this._callbacks, event);
		}
		dispose() {
			if (this._callbacks) {
				this._callbacks.dispose();
				this._callbacks = void 0;
			}
		}
	};
}));
// node_modules/vscode-jsonrpc/lib/common/cancellation.js
var require_cancellation = /* @__PURE__ */ __commonJSMin(((exports, module, this$37) => {
	var __createBinding = this$37 && this$37.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$37 && this$37.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$37 && this$37.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	var __importDefault = this$37 && this$37.__importDefault || function(mod) {
		return mod && mod.__esModule ? mod : { "default": mod };
	};
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.CancellationTokenSource = exports.CancellationToken = void 0;
	var ral_1 = __importDefault(require_ral());
	var Is = __importStar(require_is$1());
	var events_1 = require_events();
	var CancellationToken;
	(function(CancellationToken) {
		CancellationToken.None = Object.freeze({
			isCancellationRequested: false,
			onCancellationRequested: events_1.Event.None
		});
		CancellationToken.Cancelled = Object.freeze({
			isCancellationRequested: true,
			onCancellationRequested: events_1.Event.None
		});
		function is(value) {
			const candidate = value;
			return candidate && (candidate === CancellationToken.None || candidate === CancellationToken.Cancelled || Is.boolean(candidate.isCancellationRequested) && !!candidate.onCancellationRequested);
		}
		CancellationToken.is = is;
	})(CancellationToken || (exports.CancellationToken = CancellationToken = {}));
	var shortcutEvent = Object.freeze(function(callback, context) {
		const handle = (0, ral_1.default)().timer.setTimeout(callback.bind(context), 0);
		return { dispose() {
			handle.dispose();
		} };
	});
	var MutableToken = class {
		_isCancelled = false;
		_emitter;
		cancel() {
			if (!this._isCancelled) {
				this._isCancelled = true;
				if (this._emitter) {
					this._emitter.fire(void 0);
					this.dispose();
				}
			}
		}
		get isCancellationRequested() {
			return this._isCancelled;
		}
		get onCancellationRequested() {
			if (this._isCancelled) return shortcutEvent;
			if (!this._emitter) this._emitter = new events_1.Emitter();
			return this._emitter.event;
		}
		dispose() {
			if (this._emitter) {
				this._emitter.dispose();
				this._emitter = void 0;
			}
		}
	};
	var CancellationTokenSource = class {
		_token;
		get token() {
			if (!this._token) this._token = new MutableToken();
			return this._token;
		}
		cancel() {
			if (!this._token) this._token = CancellationToken.Cancelled;
			else this._token.cancel();
		}
		dispose() {
			if (!this._token) this._token = CancellationToken.None;
			else if (this._token instanceof MutableToken) this._token.dispose();
		}
	};
	exports.CancellationTokenSource = CancellationTokenSource;
}));
// node_modules/vscode-jsonrpc/lib/common/sharedArrayCancellation.js
var require_sharedArrayCancellation = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.SharedArrayReceiverStrategy = exports.SharedArraySenderStrategy = void 0;
	var cancellation_1 = require_cancellation();
	var CancellationState;
	(function(CancellationState) {
		CancellationState.Continue = 0;
		CancellationState.Cancelled = 1;
	})(CancellationState || (CancellationState = {}));
	var SharedArraySenderStrategy = class {
		buffers;
		constructor() {
			this.buffers = /* @__PURE__ */ new Map();
		}
		enableCancellation(request) {
			if (request.id === null) return;
			const buffer = new SharedArrayBuffer(4);
			const data = new Int32Array(buffer, 0, 1);
			data[0] = CancellationState.Continue;
			this.buffers.set(request.id, buffer);
			request.$cancellationData = buffer;
		}
		async sendCancellation(_conn, id) {
			const buffer = this.buffers.get(id);
			if (buffer === void 0) return;
			const data = new Int32Array(buffer, 0, 1);
			Atomics.store(data, 0, CancellationState.Cancelled);
		}
		cleanup(id) {
			this.buffers.delete(id);
		}
		dispose() {
			this.buffers.clear();
		}
	};
	exports.SharedArraySenderStrategy = SharedArraySenderStrategy;
	var SharedArrayBufferCancellationToken = class {
		data;
		constructor(buffer) {
			this.data = new Int32Array(buffer, 0, 1);
		}
		get isCancellationRequested() {
			return Atomics.load(this.data, 0) === CancellationState.Cancelled;
		}
		get onCancellationRequested() {
			throw new Error(`Cancellation over SharedArrayBuffer doesn't support cancellation events`);
		}
	};
	var SharedArrayBufferCancellationTokenSource = class {
		token;
		constructor(buffer) {
			this.token = new SharedArrayBufferCancellationToken(buffer);
		}
		cancel() {}
		dispose() {}
	};
	var SharedArrayReceiverStrategy = class {
		kind = "request";
		createCancellationTokenSource(request) {
			const buffer = request.$cancellationData;
			if (buffer === void 0) return new cancellation_1.CancellationTokenSource();
			return new SharedArrayBufferCancellationTokenSource(buffer);
		}
	};
	exports.SharedArrayReceiverStrategy = SharedArrayReceiverStrategy;
}));
// node_modules/vscode-jsonrpc/lib/common/semaphore.js
var require_semaphore = /* @__PURE__ */ __commonJSMin(((exports, module, this$36) => {
	var __importDefault = this$36 && this$36.__importDefault || function(mod) {
		return mod && mod.__esModule ? mod : { "default": mod };
	};
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.Semaphore = void 0;
	var ral_1 = __importDefault(require_ral());
	var Semaphore = class {
		_capacity;
		_active;
		_waiting;
		constructor(capacity = 1) {
			if (capacity <= 0) throw new Error("Capacity must be greater than 0");
			this._capacity = capacity;
			this._active = 0;
			this._waiting = [];
		}
		lock(thunk) {
			return new Promise((resolve, reject) => {
				this._waiting.push({
					thunk,
					resolve,
					reject
				});
				this.runNext();
			});
		}
		get active() {
			return this._active;
		}
		runNext() {
			if (this._waiting.length === 0 || this._active === this._capacity) return;
			(0, ral_1.default)().timer.setImmediate(() => this.doRunNext());
		}
		doRunNext() {
			if (this._waiting.length === 0 || this._active === this._capacity) return;
			const next = this._waiting.shift();
			this._active++;
			if (this._active > this._capacity) throw new Error(`Too many thunks active`);
			try {
				const result = next.thunk();
				if (result instanceof Promise) result.then((value) => {
					this._active--;
					next.resolve(value);
					this.runNext();
				}, (err) => {
					this._active--;
					next.reject(err);
					this.runNext();
				});
				else {
					this._active--;
					next.resolve(result);
					this.runNext();
				}
			} catch (err) {
				this._active--;
				next.reject(err);
				this.runNext();
			}
		}
	};
	exports.Semaphore = Semaphore;
}));
// node_modules/vscode-jsonrpc/lib/common/messageReader.js
var require_messageReader = /* @__PURE__ */ __commonJSMin(((exports, module, this$35) => {
	var __createBinding = this$35 && this$35.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$35 && this$35.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$35 && this$35.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	var __importDefault = this$35 && this$35.__importDefault || function(mod) {
		return mod && mod.__esModule ? mod : { "default": mod };
	};
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.ReadableStreamMessageReader = exports.AbstractMessageReader = exports.MessageReader = void 0;
	var ral_1 = __importDefault(require_ral());
	var Is = __importStar(require_is$1());
	var events_1 = require_events();
	var semaphore_1 = require_semaphore();
	var MessageReader;
	(function(MessageReader) {
		function is(value) {
			const candidate = value;
			return candidate && Is.func(candidate.listen) && Is.func(candidate.dispose) && Is.func(candidate.onError) && Is.func(candidate.onClose) && Is.func(candidate.onPartialMessage);
		}
		MessageReader.is = is;
	})(MessageReader || (exports.MessageReader = MessageReader = {}));
	var AbstractMessageReader = class {
		errorEmitter;
		closeEmitter;
		partialMessageEmitter;
		constructor() {
			this.errorEmitter = new events_1.Emitter();
			this.closeEmitter = new events_1.Emitter();
			this.partialMessageEmitter = new events_1.Emitter();
		}
		dispose() {
			this.errorEmitter.dispose();
			this.closeEmitter.dispose();
			this.partialMessageEmitter.dispose();
		}
		get onError() {
			return this.errorEmitter.event;
		}
		fireError(error) {
			this.errorEmitter.fire(this.asError(error));
		}
		get onClose() {
			return this.closeEmitter.event;
		}
		fireClose() {
			this.closeEmitter.fire(void 0);
		}
		get onPartialMessage() {
			return this.partialMessageEmitter.event;
		}
		firePartialMessage(info) {
			this.partialMessageEmitter.fire(info);
		}
		asError(error) {
			if (error instanceof Error) return error;
			else return /* @__PURE__ */ new Error(`Reader received error. Reason: ${Is.string(error.message) ? error.message : "unknown"}`);
		}
	};
	exports.AbstractMessageReader = AbstractMessageReader;
	var ResolvedMessageReaderOptions;
	(function(ResolvedMessageReaderOptions) {
		function fromOptions(options) {
			let charset;
			let contentDecoder;
			const contentDecoders = /* @__PURE__ */ new Map();
			let contentTypeDecoder;
			const contentTypeDecoders = /* @__PURE__ */ new Map();
			if (options === void 0 || typeof options === "string") charset = options ?? "utf-8";
			else {
				charset = options.charset ?? "utf-8";
				if (options.contentDecoder !== void 0) {
					contentDecoder = options.contentDecoder;
					contentDecoders.set(contentDecoder.name, contentDecoder);
				}
				if (options.contentDecoders !== void 0) for (const decoder of options.contentDecoders) contentDecoders.set(decoder.name, decoder);
				if (options.contentTypeDecoder !== void 0) {
					contentTypeDecoder = options.contentTypeDecoder;
					contentTypeDecoders.set(contentTypeDecoder.name, contentTypeDecoder);
				}
				if (options.contentTypeDecoders !== void 0) for (const decoder of options.contentTypeDecoders) contentTypeDecoders.set(decoder.name, decoder);
			}
			if (contentTypeDecoder === void 0) {
				contentTypeDecoder = (0, ral_1.default)().applicationJson.decoder;
				contentTypeDecoders.set(contentTypeDecoder.name, contentTypeDecoder);
			}
			return {
				charset,
				contentDecoder,
				contentDecoders,
				contentTypeDecoder,
				contentTypeDecoders
			};
		}
		ResolvedMessageReaderOptions.fromOptions = fromOptions;
	})(ResolvedMessageReaderOptions || (ResolvedMessageReaderOptions = {}));
	var ReadableStreamMessageReader = class extends AbstractMessageReader {
		readable;
		options;
		callback;
		nextMessageLength;
		messageToken;
		buffer;
		partialMessageTimer;
		_partialMessageTimeout;
		readSemaphore;
		constructor(readable, options) {
			super();
			this.readable = readable;
			this.options = ResolvedMessageReaderOptions.fromOptions(options);
			this.buffer = (0, ral_1.default)().messageBuffer.create(this.options.charset);
			this._partialMessageTimeout = 1e4;
			this.nextMessageLength = -1;
			this.messageToken = 0;
			this.readSemaphore = new semaphore_1.Semaphore(1);
		}
		set partialMessageTimeout(timeout) {
			this._partialMessageTimeout = timeout;
		}
		get partialMessageTimeout() {
			return this._partialMessageTimeout;
		}
		listen(callback) {
			this.nextMessageLength = -1;
			this.messageToken = 0;
			this.partialMessageTimer = void 0;
			this.callback = callback;
			const result = this.readable.onData((data) => {
				this.onData(data);
			});
			this.readable.onError((error) => this.fireError(error));
			this.readable.onClose(() => this.fireClose());
			return result;
		}
		onData(data) {
			try {
				this.buffer.append(data);
				while (true) {
					if (this.nextMessageLength === -1) {
						const headers = this.buffer.tryReadHeaders(true);
						if (!headers) return;
						const contentLength = headers.get("content-length");
						if (!contentLength) {
							this.fireError(/* @__PURE__ */ new Error(`Header must provide a Content-Length property.\n${JSON.stringify(Object.fromEntries(headers))}`));
							return;
						}
						const length = parseInt(contentLength);
						if (isNaN(length)) {
							this.fireError(/* @__PURE__ */ new Error(`Content-Length value must be a number. Got ${contentLength}`));
							return;
						}
						this.nextMessageLength = length;
					}
					const body = this.buffer.tryReadBody(this.nextMessageLength);
					if (body === void 0) {
						/** We haven't received the full message yet. */
						this.setPartialMessageTimer();
						return;
					}
					this.clearPartialMessageTimer();
					this.nextMessageLength = -1;
					this.readSemaphore.lock(async () => {
						const bytes = this.options.contentDecoder !== void 0 ? await this.options.contentDecoder.decode(body) : body;
						const message = await this.options.contentTypeDecoder.decode(bytes, this.options);
						this.callback(message);
					}).catch((error) => {
						this.fireError(error);
					});
				}
			} catch (error) {
				this.fireError(error);
			}
		}
		clearPartialMessageTimer() {
			if (this.partialMessageTimer) {
				this.partialMessageTimer.dispose();
				this.partialMessageTimer = void 0;
			}
		}
		setPartialMessageTimer() {
			this.clearPartialMessageTimer();
			if (this._partialMessageTimeout <= 0) return;
			this.partialMessageTimer = (0, ral_1.default)().timer.setTimeout((token, timeout) => {
				this.partialMessageTimer = void 0;
				if (token === this.messageToken) {
					this.firePartialMessage({
						messageToken: token,
						waitingTime: timeout
					});
					this.setPartialMessageTimer();
				}
			}, this._partialMessageTimeout, this.messageToken, this._partialMessageTimeout);
		}
	};
	exports.ReadableStreamMessageReader = ReadableStreamMessageReader;
}));
// node_modules/vscode-jsonrpc/lib/common/messageWriter.js
var require_messageWriter = /* @__PURE__ */ __commonJSMin(((exports, module, this$34) => {
	var __createBinding = this$34 && this$34.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$34 && this$34.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$34 && this$34.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	var __importDefault = this$34 && this$34.__importDefault || function(mod) {
		return mod && mod.__esModule ? mod : { "default": mod };
	};
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.WriteableStreamMessageWriter = exports.AbstractMessageWriter = exports.MessageWriter = void 0;
	var ral_1 = __importDefault(require_ral());
	var Is = __importStar(require_is$1());
	var semaphore_1 = require_semaphore();
	var events_1 = require_events();
	var ContentLength = "Content-Length: ";
	var CRLF = "\r\n";
	var MessageWriter;
	(function(MessageWriter) {
		function is(value) {
			const candidate = value;
			return candidate && Is.func(candidate.dispose) && Is.func(candidate.onClose) && Is.func(candidate.onError) && Is.func(candidate.write);
		}
		MessageWriter.is = is;
	})(MessageWriter || (exports.MessageWriter = MessageWriter = {}));
	var AbstractMessageWriter = class {
		errorEmitter;
		closeEmitter;
		constructor() {
			this.errorEmitter = new events_1.Emitter();
			this.closeEmitter = new events_1.Emitter();
		}
		dispose() {
			this.errorEmitter.dispose();
			this.closeEmitter.dispose();
		}
		get onError() {
			return this.errorEmitter.event;
		}
		fireError(error, message, count) {
			this.errorEmitter.fire([
				this.asError(error),
				message,
				count
			]);
		}
		get onClose() {
			return this.closeEmitter.event;
		}
		fireClose() {
			this.closeEmitter.fire(void 0);
		}
		asError(error) {
			if (error instanceof Error) return error;
			else return /* @__PURE__ */ new Error(`Writer received error. Reason: ${Is.string(error.message) ? error.message : "unknown"}`);
		}
	};
	exports.AbstractMessageWriter = AbstractMessageWriter;
	var ResolvedMessageWriterOptions;
	(function(ResolvedMessageWriterOptions) {
		function fromOptions(options) {
			if (options === void 0 || typeof options === "string") return {
				charset: options ?? "utf-8",
				contentTypeEncoder: (0, ral_1.default)().applicationJson.encoder
			};
			else return {
				charset: options.charset ?? "utf-8",
				contentEncoder: options.contentEncoder,
				contentTypeEncoder: options.contentTypeEncoder ?? (0, ral_1.default)().applicationJson.encoder
			};
		}
		ResolvedMessageWriterOptions.fromOptions = fromOptions;
	})(ResolvedMessageWriterOptions || (ResolvedMessageWriterOptions = {}));
	var WriteableStreamMessageWriter = class extends AbstractMessageWriter {
		writable;
		options;
		errorCount;
		writeSemaphore;
		constructor(writable, options) {
			super();
			this.writable = writable;
			this.options = ResolvedMessageWriterOptions.fromOptions(options);
			this.errorCount = 0;
			this.writeSemaphore = new semaphore_1.Semaphore(1);
			this.writable.onError((error) => this.fireError(error));
			this.writable.onClose(() => this.fireClose());
		}
		async write(msg) {
			return this.writeSemaphore.lock(async () => {
				return this.options.contentTypeEncoder.encode(msg, this.options).then((buffer) => {
					if (this.options.contentEncoder !== void 0) return this.options.contentEncoder.encode(buffer);
					else return buffer;
				}).then((buffer) => {
					const headers = [];
					headers.push(ContentLength, buffer.byteLength.toString(), CRLF);
					headers.push(CRLF);
					return this.doWrite(msg, headers, buffer);
				}, (error) => {
					this.fireError(error);
					throw error;
				});
			});
		}
		async doWrite(msg, headers, data) {
			try {
				await this.writable.write(headers.join(""), "ascii");
				return this.writable.write(data);
			} catch (error) {
				this.handleError(error, msg);
				return Promise.reject(error);
			}
		}
		handleError(error, msg) {
			this.errorCount++;
			this.fireError(error, msg, this.errorCount);
		}
		end() {
			this.writable.end();
		}
	};
	exports.WriteableStreamMessageWriter = WriteableStreamMessageWriter;
}));
// node_modules/vscode-jsonrpc/lib/common/messageBuffer.js
var require_messageBuffer = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.AbstractMessageBuffer = void 0;
	var CR = 13;
	var LF = 10;
	var CRLF = "\r\n";
	var AbstractMessageBuffer = class {
		_encoding;
		_chunks;
		_totalLength;
		constructor(encoding = "utf-8") {
			this._encoding = encoding;
			this._chunks = [];
			this._totalLength = 0;
		}
		get encoding() {
			return this._encoding;
		}
		append(chunk) {
			const toAppend = typeof chunk === "string" ? this.fromString(chunk, this._encoding) : chunk;
			this._chunks.push(toAppend);
			this._totalLength += toAppend.byteLength;
		}
		tryReadHeaders(lowerCaseKeys = false) {
			if (this._chunks.length === 0) return;
			let state = 0;
			let chunkIndex = 0;
			let offset = 0;
			let chunkBytesRead = 0;
			row: while (chunkIndex < this._chunks.length) {
				const chunk = this._chunks[chunkIndex];
				offset = 0;
				while (offset < chunk.length) {
					switch (chunk[offset]) {
						case CR:
							switch (state) {
								case 0:
									state = 1;
									break;
								case 2:
									state = 3;
									break;
								default: state = 0;
							}
							break;
						case LF:
							switch (state) {
								case 1:
									state = 2;
									break;
								case 3:
									state = 4;
									offset++;
									break row;
								default: state = 0;
							}
							break;
						default: state = 0;
					}
					offset++;
				}
				chunkBytesRead += chunk.byteLength;
				chunkIndex++;
			}
			if (state !== 4) return;
			const buffer = this._read(chunkBytesRead + offset);
			const result = /* @__PURE__ */ new Map();
			const headers = this.toString(buffer, "ascii").split(CRLF);
			if (headers.length < 2) return result;
			for (let i = 0; i < headers.length - 2; i++) {
				const header = headers[i];
				const index = header.indexOf(":");
				if (index === -1) throw new Error(`Message header must separate key and value using ':'\n${header}`);
				const key = header.substr(0, index);
				const value = header.substr(index + 1).trim();
				result.set(lowerCaseKeys ? key.toLowerCase() : key, value);
			}
			return result;
		}
		tryReadBody(length) {
			if (this._totalLength < length) return;
			return this._read(length);
		}
		get numberOfBytes() {
			return this._totalLength;
		}
		_read(byteCount) {
			if (byteCount === 0) return this.emptyBuffer();
			if (byteCount > this._totalLength) throw new Error(`Cannot read so many bytes!`);
			if (this._chunks[0].byteLength === byteCount) {
				const chunk = this._chunks[0];
				this._chunks.shift();
				this._totalLength -= byteCount;
				return this.asNative(chunk);
			}
			if (this._chunks[0].byteLength > byteCount) {
				const chunk = this._chunks[0];
				const result = this.asNative(chunk, byteCount);
				this._chunks[0] = chunk.slice(byteCount);
				this._totalLength -= byteCount;
				return result;
			}
			const result = this.allocNative(byteCount);
			let resultOffset = 0;
			const chunkIndex = 0;
			while (byteCount > 0) {
				const chunk = this._chunks[chunkIndex];
				if (chunk.byteLength > byteCount) {
					const chunkPart = chunk.slice(0, byteCount);
					result.set(chunkPart, resultOffset);
					resultOffset += byteCount;
					this._chunks[chunkIndex] = chunk.slice(byteCount);
					this._totalLength -= byteCount;
					byteCount -= byteCount;
				} else {
					result.set(chunk, resultOffset);
					resultOffset += chunk.byteLength;
					this._chunks.shift();
					this._totalLength -= chunk.byteLength;
					byteCount -= chunk.byteLength;
				}
			}
			return result;
		}
	};
	exports.AbstractMessageBuffer = AbstractMessageBuffer;
}));
// node_modules/vscode-jsonrpc/lib/common/connection.js
var require_connection$1 = /* @__PURE__ */ __commonJSMin(((exports, module, this$33) => {
	var __createBinding = this$33 && this$33.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$33 && this$33.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$33 && this$33.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	var __importDefault = this$33 && this$33.__importDefault || function(mod) {
		return mod && mod.__esModule ? mod : { "default": mod };
	};
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.ConnectionOptions = exports.MessageStrategy = exports.CancellationStrategy = exports.CancellationSenderStrategy = exports.CancellationReceiverStrategy = exports.RequestCancellationReceiverStrategy = exports.IdCancellationReceiverStrategy = exports.ConnectionStrategy = exports.ConnectionError = exports.ConnectionErrors = exports.LogTraceNotification = exports.SetTraceNotification = exports.TraceFormat = exports.TraceValues = exports.TraceValue = exports.Trace = exports.NullLogger = exports.ProgressType = exports.ProgressToken = void 0;
	exports.createMessageConnection = createMessageConnection;
	var ral_1 = __importDefault(require_ral());
	var Is = __importStar(require_is$1());
	var messages_1 = require_messages$1();
	var linkedMap_1 = require_linkedMap();
	var events_1 = require_events();
	var cancellation_1 = require_cancellation();
	var CancelNotification;
	(function(CancelNotification) {
		CancelNotification.type = new messages_1.NotificationType("$/cancelRequest");
	})(CancelNotification || (CancelNotification = {}));
	var ProgressToken;
	(function(ProgressToken) {
		function is(value) {
			return typeof value === "string" || typeof value === "number";
		}
		ProgressToken.is = is;
	})(ProgressToken || (exports.ProgressToken = ProgressToken = {}));
	var ProgressNotification;
	(function(ProgressNotification) {
		ProgressNotification.type = new messages_1.NotificationType("$/progress");
	})(ProgressNotification || (ProgressNotification = {}));
	var ProgressType = class {
		/**
		* Clients must not use these properties. They are here to ensure correct typing.
		* in TypeScript
		*/
		__;
		_pr;
		constructor() {}
	};
	exports.ProgressType = ProgressType;
	var StarRequestHandler;
	(function(StarRequestHandler) {
		function is(value) {
			return Is.func(value);
		}
		StarRequestHandler.is = is;
	})(StarRequestHandler || (StarRequestHandler = {}));
	exports.NullLogger = Object.freeze({
		error: () => {},
		warn: () => {},
		info: () => {},
		log: () => {}
	});
	var Trace;
	(function(Trace) {
		Trace[Trace["Off"] = 0] = "Off";
		Trace[Trace["Messages"] = 1] = "Messages";
		Trace[Trace["Compact"] = 2] = "Compact";
		Trace[Trace["Verbose"] = 3] = "Verbose";
	})(Trace || (exports.Trace = Trace = {}));
	var TraceValue;
	(function(TraceValue) {
		/**
		* Turn tracing off.
		*/
		TraceValue.Off = "off";
		/**
		* Trace messages only.
		*/
		TraceValue.Messages = "messages";
		/**
		* Compact message tracing.
		*/
		TraceValue.Compact = "compact";
		/**
		* Verbose message tracing.
		*/
		TraceValue.Verbose = "verbose";
	})(TraceValue || (exports.TraceValue = TraceValue = {}));
	/**
	* @deprecated Use TraceValue instead
	*/
	exports.TraceValues = TraceValue;
	(function(Trace) {
		function fromString(value) {
			if (!Is.string(value)) return Trace.Off;
			value = value.toLowerCase();
			switch (value) {
				case "off": return Trace.Off;
				case "messages": return Trace.Messages;
				case "compact": return Trace.Compact;
				case "verbose": return Trace.Verbose;
				default: return Trace.Off;
			}
		}
		Trace.fromString = fromString;
		function toString(value) {
			switch (value) {
				case Trace.Off: return "off";
				case Trace.Messages: return "messages";
				case Trace.Compact: return "compact";
				case Trace.Verbose: return "verbose";
				default: return "off";
			}
		}
		Trace.toString = toString;
	})(Trace || (exports.Trace = Trace = {}));
	var TraceFormat;
	(function(TraceFormat) {
		TraceFormat["Text"] = "text";
		TraceFormat["JSON"] = "json";
	})(TraceFormat || (exports.TraceFormat = TraceFormat = {}));
	(function(TraceFormat) {
		function fromString(value) {
			if (!Is.string(value)) return TraceFormat.Text;
			value = value.toLowerCase();
			if (value === "json") return TraceFormat.JSON;
			else return TraceFormat.Text;
		}
		TraceFormat.fromString = fromString;
	})(TraceFormat || (exports.TraceFormat = TraceFormat = {}));
	var SetTraceNotification;
	(function(SetTraceNotification) {
		SetTraceNotification.type = new messages_1.NotificationType("$/setTrace");
	})(SetTraceNotification || (exports.SetTraceNotification = SetTraceNotification = {}));
	var LogTraceNotification;
	(function(LogTraceNotification) {
		LogTraceNotification.type = new messages_1.NotificationType("$/logTrace");
	})(LogTraceNotification || (exports.LogTraceNotification = LogTraceNotification = {}));
	var ConnectionErrors;
	(function(ConnectionErrors) {
		/**
		* The connection is closed.
		*/
		ConnectionErrors[ConnectionErrors["Closed"] = 1] = "Closed";
		/**
		* The connection got disposed.
		*/
		ConnectionErrors[ConnectionErrors["Disposed"] = 2] = "Disposed";
		/**
		* The connection is already in listening mode.
		*/
		ConnectionErrors[ConnectionErrors["AlreadyListening"] = 3] = "AlreadyListening";
	})(ConnectionErrors || (exports.ConnectionErrors = ConnectionErrors = {}));
	var ConnectionError = class ConnectionError extends Error {
		code;
		constructor(code, message) {
			super(message);
			this.code = code;
			Object.setPrototypeOf(this, ConnectionError.prototype);
		}
	};
	exports.ConnectionError = ConnectionError;
	var ConnectionStrategy;
	(function(ConnectionStrategy) {
		function is(value) {
			const candidate = value;
			return candidate && Is.func(candidate.cancelUndispatched);
		}
		ConnectionStrategy.is = is;
	})(ConnectionStrategy || (exports.ConnectionStrategy = ConnectionStrategy = {}));
	var IdCancellationReceiverStrategy;
	(function(IdCancellationReceiverStrategy) {
		function is(value) {
			const candidate = value;
			return candidate && (candidate.kind === void 0 || candidate.kind === "id") && Is.func(candidate.createCancellationTokenSource) && (candidate.dispose === void 0 || Is.func(candidate.dispose));
		}
		IdCancellationReceiverStrategy.is = is;
	})(IdCancellationReceiverStrategy || (exports.IdCancellationReceiverStrategy = IdCancellationReceiverStrategy = {}));
	var RequestCancellationReceiverStrategy;
	(function(RequestCancellationReceiverStrategy) {
		function is(value) {
			const candidate = value;
			return candidate && candidate.kind === "request" && Is.func(candidate.createCancellationTokenSource) && (candidate.dispose === void 0 || Is.func(candidate.dispose));
		}
		RequestCancellationReceiverStrategy.is = is;
	})(RequestCancellationReceiverStrategy || (exports.RequestCancellationReceiverStrategy = RequestCancellationReceiverStrategy = {}));
	var CancellationReceiverStrategy;
	(function(CancellationReceiverStrategy) {
		CancellationReceiverStrategy.Message = Object.freeze({ createCancellationTokenSource(_) {
			return new cancellation_1.CancellationTokenSource();
		} });
		function is(value) {
			return IdCancellationReceiverStrategy.is(value) || RequestCancellationReceiverStrategy.is(value);
		}
		CancellationReceiverStrategy.is = is;
	})(CancellationReceiverStrategy || (exports.CancellationReceiverStrategy = CancellationReceiverStrategy = {}));
	var CancellationSenderStrategy;
	(function(CancellationSenderStrategy) {
		CancellationSenderStrategy.Message = Object.freeze({
			sendCancellation(conn, id) {
				return conn.sendNotification(CancelNotification.type, { id });
			},
			cleanup(_) {}
		});
		function is(value) {
			const candidate = value;
			return candidate && Is.func(candidate.sendCancellation) && Is.func(candidate.cleanup);
		}
		CancellationSenderStrategy.is = is;
	})(CancellationSenderStrategy || (exports.CancellationSenderStrategy = CancellationSenderStrategy = {}));
	var CancellationStrategy;
	(function(CancellationStrategy) {
		CancellationStrategy.Message = Object.freeze({
			receiver: CancellationReceiverStrategy.Message,
			sender: CancellationSenderStrategy.Message
		});
		function is(value) {
			const candidate = value;
			return candidate && CancellationReceiverStrategy.is(candidate.receiver) && CancellationSenderStrategy.is(candidate.sender);
		}
		CancellationStrategy.is = is;
	})(CancellationStrategy || (exports.CancellationStrategy = CancellationStrategy = {}));
	var MessageStrategy;
	(function(MessageStrategy) {
		function is(value) {
			const candidate = value;
			return candidate && Is.func(candidate.handleMessage);
		}
		MessageStrategy.is = is;
	})(MessageStrategy || (exports.MessageStrategy = MessageStrategy = {}));
	var ConnectionOptions;
	(function(ConnectionOptions) {
		function is(value) {
			const candidate = value;
			return candidate && (CancellationStrategy.is(candidate.cancellationStrategy) || ConnectionStrategy.is(candidate.connectionStrategy) || MessageStrategy.is(candidate.messageStrategy) || Is.number(candidate.maxParallelism));
		}
		ConnectionOptions.is = is;
	})(ConnectionOptions || (exports.ConnectionOptions = ConnectionOptions = {}));
	var ConnectionState;
	(function(ConnectionState) {
		ConnectionState[ConnectionState["New"] = 1] = "New";
		ConnectionState[ConnectionState["Listening"] = 2] = "Listening";
		ConnectionState[ConnectionState["Closed"] = 3] = "Closed";
		ConnectionState[ConnectionState["Disposed"] = 4] = "Disposed";
	})(ConnectionState || (ConnectionState = {}));
	function createMessageConnection(messageReader, messageWriter, _logger, options) {
		const logger = _logger !== void 0 ? _logger : exports.NullLogger;
		let sequenceNumber = 0;
		let notificationSequenceNumber = 0;
		let unknownResponseSequenceNumber = 0;
		const version = "2.0";
		const maxParallelism = options?.maxParallelism ?? -1;
		let inFlight = 0;
		let starRequestHandler = void 0;
		const requestHandlers = /* @__PURE__ */ new Map();
		let starNotificationHandler = void 0;
		const notificationHandlers = /* @__PURE__ */ new Map();
		const progressHandlers = /* @__PURE__ */ new Map();
		let timer;
		let messageQueue = new linkedMap_1.LinkedMap();
		let responsePromises = /* @__PURE__ */ new Map();
		let knownCanceledRequests = /* @__PURE__ */ new Set();
		let requestTokens = /* @__PURE__ */ new Map();
		let trace = Trace.Off;
		let traceFormat = TraceFormat.Text;
		let tracer;
		let state = ConnectionState.New;
		const errorEmitter = new events_1.Emitter();
		const closeEmitter = new events_1.Emitter();
		const unhandledNotificationEmitter = new events_1.Emitter();
		const unhandledProgressEmitter = new events_1.Emitter();
		const disposeEmitter = new events_1.Emitter();
		const cancellationStrategy = options && options.cancellationStrategy ? options.cancellationStrategy : CancellationStrategy.Message;
		function cancelUndispatched(_message) {}
		function isListening() {
			return state === ConnectionState.Listening;
		}
		function isClosed() {
			return state === ConnectionState.Closed;
		}
		function isDisposed() {
			return state === ConnectionState.Disposed;
		}
		function closeHandler() {
			if (state === ConnectionState.New || state === ConnectionState.Listening) {
				state = ConnectionState.Closed;
				closeEmitter.fire(void 0);
			}
		}
		function readErrorHandler(error) {
			errorEmitter.fire([
				error,
				void 0,
				void 0
			]);
		}
		function writeErrorHandler(data) {
			errorEmitter.fire(data);
		}
		messageReader.onClose(closeHandler);
		messageReader.onError(readErrorHandler);
		messageWriter.onClose(closeHandler);
		messageWriter.onError(writeErrorHandler);
		function createRequestQueueKey(id) {
			if (id === null) throw new Error(`Can't send requests with id null since the response can't be correlated.`);
			return "req-" + id.toString();
		}
		function createResponseQueueKey(id) {
			if (id === null) return "res-unknown-" + (++unknownResponseSequenceNumber).toString();
			else return "res-" + id.toString();
		}
		function createNotificationQueueKey() {
			return "not-" + (++notificationSequenceNumber).toString();
		}
		function addMessageToQueue(queue, message) {
			if (messages_1.Message.isRequest(message)) queue.set(createRequestQueueKey(message.id), message);
			else if (messages_1.Message.isResponse(message)) {
				if (maxParallelism === -1) queue.set(createResponseQueueKey(message.id), message);
				else handleResponse(message);
			} else queue.set(createNotificationQueueKey(), message);
		}
		function triggerMessageQueue() {
			if (timer || messageQueue.size === 0) return;
			if (maxParallelism !== -1 && inFlight >= maxParallelism) return;
			timer = (0, ral_1.default)().timer.setImmediate(async () => {
				timer = void 0;
				if (messageQueue.size === 0) return;
				if (maxParallelism !== -1 && inFlight >= maxParallelism) return;
				const message = messageQueue.shift();
				let result;
				try {
					inFlight++;
					const messageStrategy = options?.messageStrategy;
					if (MessageStrategy.is(messageStrategy)) result = messageStrategy.handleMessage(message, handleMessage);
					else result = handleMessage(message);
				} catch (error) {
					logger.error(`Processing message queue failed: ${error.toString()}`);
				} finally {
					if (result instanceof Promise) result.then(() => {}).catch((error) => {
						logger.error(`Processing message queue failed: ${error.toString()}`);
					}).finally(() => {
						inFlight--;
						triggerMessageQueue();
					});
					else inFlight--;
					triggerMessageQueue();
				}
			});
		}
		async function handleMessage(message) {
			if (messages_1.Message.isRequest(message)) return handleRequest(message);
			else if (messages_1.Message.isNotification(message)) return handleNotification(message);
			else if (messages_1.Message.isResponse(message)) return handleResponse(message);
			else return handleInvalidMessage(message);
		}
		const callback = (message) => {
			try {
				if (messages_1.Message.isNotification(message) && message.method === CancelNotification.type.method) {
					const cancelId = message.params.id;
					const key = createRequestQueueKey(cancelId);
					const toCancel = messageQueue.get(key);
					if (messages_1.Message.isRequest(toCancel)) {
						const strategy = options?.connectionStrategy;
						const response = strategy && strategy.cancelUndispatched ? strategy.cancelUndispatched(toCancel, cancelUndispatched) : void 0;
						if (response && (response.error !== void 0 || response.result !== void 0)) {
							messageQueue.delete(key);
							requestTokens.delete(cancelId);
							response.id = toCancel.id;
							traceSendingResponse(response, message.method, Date.now());
							messageWriter.write(response).catch(() => logger.error(`Sending response for canceled message failed.`));
							return;
						}
					}
					const cancellationToken = requestTokens.get(cancelId);
					if (cancellationToken !== void 0) {
						cancellationToken.cancel();
						traceReceivedNotification(message);
						return;
					} else knownCanceledRequests.add(cancelId);
				}
				addMessageToQueue(messageQueue, message);
			} finally {
				triggerMessageQueue();
			}
		};
		async function handleRequest(requestMessage) {
			if (isDisposed()) return Promise.resolve();
			function reply(resultOrError, method, startTime) {
				const message = {
					jsonrpc: version,
					id: requestMessage.id
				};
				if (resultOrError instanceof messages_1.ResponseError) message.error = resultOrError.toJson();
				else message.result = resultOrError === void 0 ? null : resultOrError;
				traceSendingResponse(message, method, startTime);
				return messageWriter.write(message);
			}
			function replyError(error, method, startTime) {
				const message = {
					jsonrpc: version,
					id: requestMessage.id,
					error: error.toJson()
				};
				traceSendingResponse(message, method, startTime);
				return messageWriter.write(message);
			}
			traceReceivedRequest(requestMessage);
			const element = requestHandlers.get(requestMessage.method);
			let type;
			let requestHandler;
			if (element) {
				type = element.type;
				requestHandler = element.handler;
			}
			const startTime = Date.now();
			if (requestHandler || starRequestHandler) {
				const tokenKey = requestMessage.id ?? String(Date.now());
				const cancellationSource = IdCancellationReceiverStrategy.is(cancellationStrategy.receiver) ? cancellationStrategy.receiver.createCancellationTokenSource(tokenKey) : cancellationStrategy.receiver.createCancellationTokenSource(requestMessage);
				if (requestMessage.id !== null && knownCanceledRequests.has(requestMessage.id)) cancellationSource.cancel();
				if (requestMessage.id !== null) requestTokens.set(tokenKey, cancellationSource);
				try {
					let handlerResult;
					if (requestHandler) {
						if (requestMessage.params === void 0) {
							if (type !== void 0 && type.numberOfParams !== 0) return replyError(new messages_1.ResponseError(messages_1.ErrorCodes.InvalidParams, `Request ${requestMessage.method} defines ${type.numberOfParams} params but received none.`), requestMessage.method, startTime);
							handlerResult = requestHandler(cancellationSource.token);
						} else if (Array.isArray(requestMessage.params)) {
							if (type !== void 0 && type.parameterStructures === messages_1.ParameterStructures.byName) return replyError(new messages_1.ResponseError(messages_1.ErrorCodes.InvalidParams, `Request ${requestMessage.method} defines parameters by name but received parameters by position`), requestMessage.method, startTime);
							handlerResult = requestHandler(...requestMessage.params, cancellationSource.token);
						} else {
							if (type !== void 0 && type.parameterStructures === messages_1.ParameterStructures.byPosition) return replyError(new messages_1.ResponseError(messages_1.ErrorCodes.InvalidParams, `Request ${requestMessage.method} defines parameters by position but received parameters by name`), requestMessage.method, startTime);
							handlerResult = requestHandler(requestMessage.params, cancellationSource.token);
						}
					} else if (starRequestHandler) handlerResult = starRequestHandler(requestMessage.method, requestMessage.params, cancellationSource.token);
					await reply(await handlerResult, requestMessage.method, startTime);
				} catch (error) {
					if (error instanceof messages_1.ResponseError) await reply(error, requestMessage.method, startTime);
					else if (error && Is.string(error.message)) await replyError(new messages_1.ResponseError(messages_1.ErrorCodes.InternalError, `Request ${requestMessage.method} failed with message: ${error.message}`), requestMessage.method, startTime);
					else await replyError(new messages_1.ResponseError(messages_1.ErrorCodes.InternalError, `Request ${requestMessage.method} failed unexpectedly without providing any details.`), requestMessage.method, startTime);
				} finally {
					requestTokens.delete(tokenKey);
				}
			} else await replyError(new messages_1.ResponseError(messages_1.ErrorCodes.MethodNotFound, `Unhandled method ${requestMessage.method}`), requestMessage.method, startTime);
		}
		function handleResponse(responseMessage) {
			if (isDisposed()) return;
			if (responseMessage.id === null) {
				if (responseMessage.error) logger.error(`Received response message without id: Error is: \n${JSON.stringify(responseMessage.error, void 0, 4)}`);
				else logger.error(`Received response message without id. No further error information provided.`);
			} else {
				const key = responseMessage.id;
				const responsePromise = responsePromises.get(key);
				traceReceivedResponse(responseMessage, responsePromise);
				if (responsePromise !== void 0) {
					responsePromises.delete(key);
					try {
						if (responseMessage.error) {
							const error = responseMessage.error;
							responsePromise.reject(new messages_1.ResponseError(error.code, error.message, error.data));
						} else if (responseMessage.result !== void 0) responsePromise.resolve(responseMessage.result);
						else throw new Error("Should never happen.");
					} catch (error) {
						if (error.message) logger.error(`Response handler '${responsePromise.method}' failed with message: ${error.message}`);
						else logger.error(`Response handler '${responsePromise.method}' failed unexpectedly.`);
					}
				}
			}
		}
		async function handleNotification(message) {
			if (isDisposed()) return;
			let type = void 0;
			let notificationHandler;
			if (message.method === CancelNotification.type.method) {
				const cancelId = message.params.id;
				knownCanceledRequests.delete(cancelId);
				traceReceivedNotification(message);
				return;
			} else {
				const element = notificationHandlers.get(message.method);
				if (element) {
					notificationHandler = element.handler;
					type = element.type;
				}
			}
			if (notificationHandler || starNotificationHandler) try {
				traceReceivedNotification(message);
				if (notificationHandler) {
					if (message.params === void 0) {
						if (type !== void 0) {
							if (type.numberOfParams !== 0 && type.parameterStructures !== messages_1.ParameterStructures.byName) logger.error(`Notification ${message.method} defines ${type.numberOfParams} params but received none.`);
						}
						await notificationHandler();
					} else if (Array.isArray(message.params)) {
						const params = message.params;
						if (message.method === ProgressNotification.type.method && params.length === 2 && ProgressToken.is(params[0])) await notificationHandler({
							token: params[0],
							value: params[1]
						});
						else {
							if (type !== void 0) {
								if (type.parameterStructures === messages_1.ParameterStructures.byName) logger.error(`Notification ${message.method} defines parameters by name but received parameters by position`);
								if (type.numberOfParams !== message.params.length) logger.error(`Notification ${message.method} defines ${type.numberOfParams} params but received ${params.length} arguments`);
							}
							await notificationHandler(...params);
						}
					} else {
						if (type !== void 0 && type.parameterStructures === messages_1.ParameterStructures.byPosition) logger.error(`Notification ${message.method} defines parameters by position but received parameters by name`);
						await notificationHandler(message.params);
					}
				} else if (starNotificationHandler) await starNotificationHandler(message.method, message.params);
			} catch (error) {
				if (error.message) logger.error(`Notification handler '${message.method}' failed with message: ${error.message}`);
				else logger.error(`Notification handler '${message.method}' failed unexpectedly.`);
			}
			else unhandledNotificationEmitter.fire(message);
		}
		function handleInvalidMessage(message) {
			if (!message) {
				logger.error("Received empty message.");
				return;
			}
			logger.error(`Received message which is neither a response nor a notification message:\n${JSON.stringify(message, null, 4)}`);
			const responseMessage = message;
			if (Is.string(responseMessage.id) || Is.number(responseMessage.id)) {
				const key = responseMessage.id;
				const responseHandler = responsePromises.get(key);
				if (responseHandler) responseHandler.reject(/* @__PURE__ */ new Error("The received response has neither a result nor an error property."));
			}
		}
		function stringifyTrace(params) {
			if (params === void 0 || params === null) return;
			switch (trace) {
				case Trace.Verbose: return JSON.stringify(params, null, 4);
				case Trace.Compact: return JSON.stringify(params);
				default: return;
			}
		}
		function traceSendingRequest(message) {
			if (trace === Trace.Off || !tracer) return;
			if (traceFormat === TraceFormat.Text) {
				let data = void 0;
				if ((trace === Trace.Verbose || trace === Trace.Compact) && message.params) data = `Params: ${stringifyTrace(message.params)}`;
				tracer.log(`Sending request '${message.method} - (${message.id})'.`, data);
			} else logLSPMessage("send-request", message);
		}
		function traceSendingNotification(message) {
			if (trace === Trace.Off || !tracer) return;
			if (traceFormat === TraceFormat.Text) {
				let data = void 0;
				if (trace === Trace.Verbose || trace === Trace.Compact) {
					if (message.params) data = `Params: ${stringifyTrace(message.params)}`;
					else data = "No parameters provided.";
				}
				tracer.log(`Sending notification '${message.method}'.`, data);
			} else logLSPMessage("send-notification", message);
		}
		function traceSendingResponse(message, method, startTime) {
			if (trace === Trace.Off || !tracer) return;
			if (traceFormat === TraceFormat.Text) {
				let data = void 0;
				if (trace === Trace.Verbose || trace === Trace.Compact) {
					if (message.error && message.error.data) data = `Error data: ${stringifyTrace(message.error.data)}`;
					else if (message.result) data = `Result: ${stringifyTrace(message.result)}`;
					else if (message.error === void 0) data = "No result returned.";
				}
				const error = message.error ? ` Request failed: ${message.error.message} (${message.error.code}).` : "";
				tracer.log(`Sending response '${method} - (${message.id})'. Processing request took ${Date.now() - startTime}ms.${error}`, data);
			} else logLSPMessage("send-response", message);
		}
		function traceReceivedRequest(message) {
			if (trace === Trace.Off || !tracer) return;
			if (traceFormat === TraceFormat.Text) {
				let data = void 0;
				if ((trace === Trace.Verbose || trace === Trace.Compact) && message.params) data = `Params: ${stringifyTrace(message.params)}`;
				tracer.log(`Received request '${message.method} - (${message.id})'.`, data);
			} else logLSPMessage("receive-request", message);
		}
		function traceReceivedNotification(message) {
			if (trace === Trace.Off || !tracer || message.method === LogTraceNotification.type.method) return;
			if (traceFormat === TraceFormat.Text) {
				let data = void 0;
				if (trace === Trace.Verbose || trace === Trace.Compact) {
					if (message.params) data = `Params: ${stringifyTrace(message.params)}`;
					else data = "No parameters provided.";
				}
				tracer.log(`Received notification '${message.method}'.`, data);
			} else logLSPMessage("receive-notification", message);
		}
		function traceReceivedResponse(message, responsePromise) {
			if (trace === Trace.Off || !tracer) return;
			if (traceFormat === TraceFormat.Text) {
				let data = void 0;
				if (trace === Trace.Verbose || trace === Trace.Compact) {
					if (message.error && message.error.data) data = `Error data: ${stringifyTrace(message.error.data)}`;
					else if (message.result) data = `Result: ${stringifyTrace(message.result)}`;
					else if (message.error === void 0) data = "No result returned.";
				}
				if (responsePromise) {
					const error = message.error ? ` Request failed: ${message.error.message} (${message.error.code}).` : "";
					tracer.log(`Received response '${responsePromise.method} - (${message.id})' in ${Date.now() - responsePromise.timerStart}ms.${error}`, data);
				} else tracer.log(`Received response ${message.id} without active response promise.`, data);
			} else logLSPMessage("receive-response", message);
		}
		function logLSPMessage(type, message) {
			if (!tracer || trace === Trace.Off) return;
			const lspMessage = {
				isLSPMessage: true,
				type,
				message,
				timestamp: Date.now()
			};
			tracer.log(lspMessage);
		}
		function throwIfClosedOrDisposed() {
			if (isClosed()) throw new ConnectionError(ConnectionErrors.Closed, "Connection is closed.");
			if (isDisposed()) throw new ConnectionError(ConnectionErrors.Disposed, "Connection is disposed.");
		}
		function throwIfListening() {
			if (isListening()) throw new ConnectionError(ConnectionErrors.AlreadyListening, "Connection is already listening");
		}
		function throwIfNotListening() {
			if (!isListening()) throw new Error("Call listen() first.");
		}
		function undefinedToNull(param) {
			if (param === void 0) return null;
			else return param;
		}
		function nullToUndefined(param) {
			if (param === null) return;
			else return param;
		}
		function isNamedParam(param) {
			return param !== void 0 && param !== null && !Array.isArray(param) && typeof param === "object";
		}
		function computeSingleParam(parameterStructures, param) {
			switch (parameterStructures) {
				case messages_1.ParameterStructures.auto: if (isNamedParam(param)) return nullToUndefined(param);
				else return [undefinedToNull(param)];
				case messages_1.ParameterStructures.byName:
					if (!isNamedParam(param)) throw new Error(`Received parameters by name but param is not an object literal.`);
					return nullToUndefined(param);
				case messages_1.ParameterStructures.byPosition: return [undefinedToNull(param)];
				default: throw new Error(`Unknown parameter structure ${parameterStructures.toString()}`);
			}
		}
		function computeMessageParams(type, params) {
			let result;
			const numberOfParams = type.numberOfParams;
			switch (numberOfParams) {
				case 0:
					result = void 0;
					break;
				case 1:
					result = computeSingleParam(type.parameterStructures, params[0]);
					break;
				default:
					result = [];
					for (let i = 0; i < params.length && i < numberOfParams; i++) result.push(undefinedToNull(params[i]));
					if (params.length < numberOfParams) for (let i = params.length; i < numberOfParams; i++) result.push(null);
			}
			return result;
		}
		const connection = {
			sendNotification: (type, ...args) => {
				throwIfClosedOrDisposed();
				let method;
				let messageParams;
				if (Is.string(type)) {
					method = type;
					const first = args[0];
					let paramStart = 0;
					let parameterStructures = messages_1.ParameterStructures.auto;
					if (messages_1.ParameterStructures.is(first)) {
						paramStart = 1;
						parameterStructures = first;
					}
					const paramEnd = args.length;
					const numberOfParams = paramEnd - paramStart;
					switch (numberOfParams) {
						case 0:
							messageParams = void 0;
							break;
						case 1:
							messageParams = computeSingleParam(parameterStructures, args[paramStart]);
							break;
						default:
							if (parameterStructures === messages_1.ParameterStructures.byName) throw new Error(`Received ${numberOfParams} parameters for 'by Name' notification parameter structure.`);
							messageParams = args.slice(paramStart, paramEnd).map((value) => undefinedToNull(value));
					}
				} else {
					const params = args;
					method = type.method;
					messageParams = computeMessageParams(type, params);
				}
				const notificationMessage = {
					jsonrpc: version,
					method,
					params: messageParams
				};
				traceSendingNotification(notificationMessage);
				return messageWriter.write(notificationMessage).catch((error) => {
					logger.error(`Sending notification failed.`);
					throw error;
				});
			},
			onNotification: (type, handler) => {
				throwIfClosedOrDisposed();
				let method;
				if (Is.func(type)) starNotificationHandler = type;
				else if (handler) {
					if (Is.string(type)) {
						method = type;
						notificationHandlers.set(type, {
							type: void 0,
							handler
						});
					} else {
						method = type.method;
						notificationHandlers.set(type.method, {
							type,
							handler
						});
					}
				}
				return { dispose: () => {
					if (method !== void 0) {
						if (notificationHandlers.get(method)?.handler === handler) notificationHandlers.delete(method);
					} else if (starNotificationHandler === type) starNotificationHandler = void 0;
				} };
			},
			onProgress: (_type, token, handler) => {
				if (progressHandlers.has(token)) throw new Error(`Progress handler for token ${token} already registered`);
				progressHandlers.set(token, handler);
				return { dispose: () => {
					if (progressHandlers.get(token) === handler) progressHandlers.delete(token);
				} };
			},
			sendProgress: (_type, token, value) => {
				return connection.sendNotification(ProgressNotification.type, {
					token,
					value
				});
			},
			onUnhandledProgress: unhandledProgressEmitter.event,
			sendRequest: (type, ...args) => {
				throwIfClosedOrDisposed();
				throwIfNotListening();
				function sendCancellation(connection, id) {
					const p = cancellationStrategy.sender.sendCancellation(connection, id);
					if (p === void 0) logger.log(`Received no promise from cancellation strategy when cancelling id ${id}`);
					else p.catch(() => {
						logger.log(`Sending cancellation messages for id ${id} failed.`);
					});
				}
				let method;
				let messageParams;
				let token = void 0;
				if (Is.string(type)) {
					method = type;
					const first = args[0];
					const last = args[args.length - 1];
					let paramStart = 0;
					let parameterStructures = messages_1.ParameterStructures.auto;
					if (messages_1.ParameterStructures.is(first)) {
						paramStart = 1;
						parameterStructures = first;
					}
					let paramEnd = args.length;
					if (cancellation_1.CancellationToken.is(last)) {
						paramEnd = paramEnd - 1;
						token = last;
					}
					const numberOfParams = paramEnd - paramStart;
					switch (numberOfParams) {
						case 0:
							messageParams = void 0;
							break;
						case 1:
							messageParams = computeSingleParam(parameterStructures, args[paramStart]);
							break;
						default:
							if (parameterStructures === messages_1.ParameterStructures.byName) throw new Error(`Received ${numberOfParams} parameters for 'by Name' request parameter structure.`);
							messageParams = args.slice(paramStart, paramEnd).map((value) => undefinedToNull(value));
					}
				} else {
					const params = args;
					method = type.method;
					messageParams = computeMessageParams(type, params);
					const numberOfParams = type.numberOfParams;
					token = cancellation_1.CancellationToken.is(params[numberOfParams]) ? params[numberOfParams] : void 0;
				}
				const id = sequenceNumber++;
				let disposable;
				let tokenWasCancelled = false;
				if (token !== void 0) {
					if (token.isCancellationRequested) tokenWasCancelled = true;
					else disposable = token.onCancellationRequested(() => {
						sendCancellation(connection, id);
					});
				}
				const requestMessage = {
					jsonrpc: version,
					id,
					method,
					params: messageParams
				};
				traceSendingRequest(requestMessage);
				if (typeof cancellationStrategy.sender.enableCancellation === "function") cancellationStrategy.sender.enableCancellation(requestMessage);
				return new Promise(async (resolve, reject) => {
					const resolveWithCleanup = (r) => {
						resolve(r);
						cancellationStrategy.sender.cleanup(id);
						disposable?.dispose();
					};
					const rejectWithCleanup = (r) => {
						reject(r);
						cancellationStrategy.sender.cleanup(id);
						disposable?.dispose();
					};
					const responsePromise = {
						method,
						timerStart: Date.now(),
						resolve: resolveWithCleanup,
						reject: rejectWithCleanup
					};
					try {
						responsePromises.set(id, responsePromise);
						await messageWriter.write(requestMessage);
						if (tokenWasCancelled) sendCancellation(connection, id);
					} catch (error) {
						responsePromises.delete(id);
						responsePromise.reject(new messages_1.ResponseError(messages_1.ErrorCodes.MessageWriteError, error.message ? error.message : "Unknown reason"));
						logger.error(`Sending request failed.`);
					}
				});
			},
			onRequest: (type, handler) => {
				throwIfClosedOrDisposed();
				let method = null;
				if (StarRequestHandler.is(type)) {
					method = void 0;
					starRequestHandler = type;
				} else if (Is.string(type)) {
					method = null;
					if (handler !== void 0) {
						method = type;
						requestHandlers.set(type, {
							handler,
							type: void 0
						});
					}
				} else if (handler !== void 0) {
					method = type.method;
					requestHandlers.set(type.method, {
						type,
						handler
					});
				}
				return { dispose: () => {
					if (method === null) return;
					if (method !== void 0) {
						if (requestHandlers.get(method)?.handler === handler) requestHandlers.delete(method);
					} else if (starRequestHandler === type) starRequestHandler = void 0;
				} };
			},
			hasPendingResponse: () => {
				return responsePromises.size > 0;
			},
			trace: async (_value, _tracer, sendNotificationOrTraceOptions) => {
				let _sendNotification = false;
				let _traceFormat = TraceFormat.Text;
				if (sendNotificationOrTraceOptions !== void 0) {
					if (Is.boolean(sendNotificationOrTraceOptions)) _sendNotification = sendNotificationOrTraceOptions;
					else {
						_sendNotification = sendNotificationOrTraceOptions.sendNotification || false;
						_traceFormat = sendNotificationOrTraceOptions.traceFormat || TraceFormat.Text;
					}
				}
				trace = _value;
				traceFormat = _traceFormat;
				if (trace === Trace.Off) tracer = void 0;
				else tracer = _tracer;
				if (_sendNotification && !isClosed() && !isDisposed()) await connection.sendNotification(SetTraceNotification.type, { value: Trace.toString(_value) });
			},
			onError: errorEmitter.event,
			onClose: closeEmitter.event,
			onUnhandledNotification: unhandledNotificationEmitter.event,
			onDispose: disposeEmitter.event,
			end: () => {
				messageWriter.end();
			},
			dispose: () => {
				if (isDisposed()) return;
				state = ConnectionState.Disposed;
				disposeEmitter.fire(void 0);
				const error = new messages_1.ResponseError(messages_1.ErrorCodes.PendingResponseRejected, "Pending response rejected since connection got disposed");
				for (const promise of responsePromises.values()) promise.reject(error);
				responsePromises = /* @__PURE__ */ new Map();
				requestTokens = /* @__PURE__ */ new Map();
				knownCanceledRequests = /* @__PURE__ */ new Set();
				messageQueue = new linkedMap_1.LinkedMap();
				if (Is.func(messageWriter.dispose)) messageWriter.dispose();
				if (Is.func(messageReader.dispose)) messageReader.dispose();
			},
			listen: () => {
				throwIfClosedOrDisposed();
				throwIfListening();
				state = ConnectionState.Listening;
				messageReader.listen(callback);
			},
			inspect: () => {
				(0, ral_1.default)().console.log("inspect");
			}
		};
		connection.onNotification(LogTraceNotification.type, (params) => {
			if (trace === Trace.Off || !tracer) return;
			const verbose = trace === Trace.Verbose || trace === Trace.Compact;
			tracer.log(params.message, verbose ? params.verbose : void 0);
		});
		connection.onNotification(ProgressNotification.type, async (params) => {
			const handler = progressHandlers.get(params.token);
			if (handler) await handler(params.value);
			else unhandledProgressEmitter.fire(params);
		});
		return connection;
	}
}));
// node_modules/vscode-jsonrpc/lib/common/api.js
var require_api$2 = /* @__PURE__ */ __commonJSMin(((exports, module, this$32) => {
	var __importDefault = this$32 && this$32.__importDefault || function(mod) {
		return mod && mod.__esModule ? mod : { "default": mod };
	};
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.ProgressType = exports.ProgressToken = exports.createMessageConnection = exports.NullLogger = exports.ConnectionOptions = exports.ConnectionStrategy = exports.AbstractMessageBuffer = exports.WriteableStreamMessageWriter = exports.AbstractMessageWriter = exports.MessageWriter = exports.ReadableStreamMessageReader = exports.AbstractMessageReader = exports.MessageReader = exports.SharedArrayReceiverStrategy = exports.SharedArraySenderStrategy = exports.CancellationToken = exports.CancellationTokenSource = exports.Emitter = exports.Event = exports.Disposable = exports.LRUCache = exports.Touch = exports.LinkedMap = exports.ParameterStructures = exports.NotificationType9 = exports.NotificationType8 = exports.NotificationType7 = exports.NotificationType6 = exports.NotificationType5 = exports.NotificationType4 = exports.NotificationType3 = exports.NotificationType2 = exports.NotificationType1 = exports.NotificationType0 = exports.NotificationType = exports.ErrorCodes = exports.ResponseError = exports.RequestType9 = exports.RequestType8 = exports.RequestType7 = exports.RequestType6 = exports.RequestType5 = exports.RequestType4 = exports.RequestType3 = exports.RequestType2 = exports.RequestType1 = exports.RequestType0 = exports.RequestType = exports.Message = exports.RAL = void 0;
	exports.MessageStrategy = exports.CancellationStrategy = exports.CancellationSenderStrategy = exports.RequestCancellationReceiverStrategy = exports.IdCancellationReceiverStrategy = exports.CancellationReceiverStrategy = exports.ConnectionError = exports.ConnectionErrors = exports.LogTraceNotification = exports.SetTraceNotification = exports.TraceFormat = exports.TraceValues = exports.TraceValue = exports.Trace = void 0;
	var messages_1 = require_messages$1();
	Object.defineProperty(exports, "Message", {
		enumerable: true,
		get: function() {
			return messages_1.Message;
		}
	});
	Object.defineProperty(exports, "RequestType", {
		enumerable: true,
		get: function() {
			return messages_1.RequestType;
		}
	});
	Object.defineProperty(exports, "RequestType0", {
		enumerable: true,
		get: function() {
			return messages_1.RequestType0;
		}
	});
	Object.defineProperty(exports, "RequestType1", {
		enumerable: true,
		get: function() {
			return messages_1.RequestType1;
		}
	});
	Object.defineProperty(exports, "RequestType2", {
		enumerable: true,
		get: function() {
			return messages_1.RequestType2;
		}
	});
	Object.defineProperty(exports, "RequestType3", {
		enumerable: true,
		get: function() {
			return messages_1.RequestType3;
		}
	});
	Object.defineProperty(exports, "RequestType4", {
		enumerable: true,
		get: function() {
			return messages_1.RequestType4;
		}
	});
	Object.defineProperty(exports, "RequestType5", {
		enumerable: true,
		get: function() {
			return messages_1.RequestType5;
		}
	});
	Object.defineProperty(exports, "RequestType6", {
		enumerable: true,
		get: function() {
			return messages_1.RequestType6;
		}
	});
	Object.defineProperty(exports, "RequestType7", {
		enumerable: true,
		get: function() {
			return messages_1.RequestType7;
		}
	});
	Object.defineProperty(exports, "RequestType8", {
		enumerable: true,
		get: function() {
			return messages_1.RequestType8;
		}
	});
	Object.defineProperty(exports, "RequestType9", {
		enumerable: true,
		get: function() {
			return messages_1.RequestType9;
		}
	});
	Object.defineProperty(exports, "ResponseError", {
		enumerable: true,
		get: function() {
			return messages_1.ResponseError;
		}
	});
	Object.defineProperty(exports, "ErrorCodes", {
		enumerable: true,
		get: function() {
			return messages_1.ErrorCodes;
		}
	});
	Object.defineProperty(exports, "NotificationType", {
		enumerable: true,
		get: function() {
			return messages_1.NotificationType;
		}
	});
	Object.defineProperty(exports, "NotificationType0", {
		enumerable: true,
		get: function() {
			return messages_1.NotificationType0;
		}
	});
	Object.defineProperty(exports, "NotificationType1", {
		enumerable: true,
		get: function() {
			return messages_1.NotificationType1;
		}
	});
	Object.defineProperty(exports, "NotificationType2", {
		enumerable: true,
		get: function() {
			return messages_1.NotificationType2;
		}
	});
	Object.defineProperty(exports, "NotificationType3", {
		enumerable: true,
		get: function() {
			return messages_1.NotificationType3;
		}
	});
	Object.defineProperty(exports, "NotificationType4", {
		enumerable: true,
		get: function() {
			return messages_1.NotificationType4;
		}
	});
	Object.defineProperty(exports, "NotificationType5", {
		enumerable: true,
		get: function() {
			return messages_1.NotificationType5;
		}
	});
	Object.defineProperty(exports, "NotificationType6", {
		enumerable: true,
		get: function() {
			return messages_1.NotificationType6;
		}
	});
	Object.defineProperty(exports, "NotificationType7", {
		enumerable: true,
		get: function() {
			return messages_1.NotificationType7;
		}
	});
	Object.defineProperty(exports, "NotificationType8", {
		enumerable: true,
		get: function() {
			return messages_1.NotificationType8;
		}
	});
	Object.defineProperty(exports, "NotificationType9", {
		enumerable: true,
		get: function() {
			return messages_1.NotificationType9;
		}
	});
	Object.defineProperty(exports, "ParameterStructures", {
		enumerable: true,
		get: function() {
			return messages_1.ParameterStructures;
		}
	});
	var linkedMap_1 = require_linkedMap();
	Object.defineProperty(exports, "LinkedMap", {
		enumerable: true,
		get: function() {
			return linkedMap_1.LinkedMap;
		}
	});
	Object.defineProperty(exports, "LRUCache", {
		enumerable: true,
		get: function() {
			return linkedMap_1.LRUCache;
		}
	});
	Object.defineProperty(exports, "Touch", {
		enumerable: true,
		get: function() {
			return linkedMap_1.Touch;
		}
	});
	var disposable_1 = require_disposable();
	Object.defineProperty(exports, "Disposable", {
		enumerable: true,
		get: function() {
			return disposable_1.Disposable;
		}
	});
	var events_1 = require_events();
	Object.defineProperty(exports, "Event", {
		enumerable: true,
		get: function() {
			return events_1.Event;
		}
	});
	Object.defineProperty(exports, "Emitter", {
		enumerable: true,
		get: function() {
			return events_1.Emitter;
		}
	});
	var cancellation_1 = require_cancellation();
	Object.defineProperty(exports, "CancellationTokenSource", {
		enumerable: true,
		get: function() {
			return cancellation_1.CancellationTokenSource;
		}
	});
	Object.defineProperty(exports, "CancellationToken", {
		enumerable: true,
		get: function() {
			return cancellation_1.CancellationToken;
		}
	});
	var sharedArrayCancellation_1 = require_sharedArrayCancellation();
	Object.defineProperty(exports, "SharedArraySenderStrategy", {
		enumerable: true,
		get: function() {
			return sharedArrayCancellation_1.SharedArraySenderStrategy;
		}
	});
	Object.defineProperty(exports, "SharedArrayReceiverStrategy", {
		enumerable: true,
		get: function() {
			return sharedArrayCancellation_1.SharedArrayReceiverStrategy;
		}
	});
	var messageReader_1 = require_messageReader();
	Object.defineProperty(exports, "MessageReader", {
		enumerable: true,
		get: function() {
			return messageReader_1.MessageReader;
		}
	});
	Object.defineProperty(exports, "AbstractMessageReader", {
		enumerable: true,
		get: function() {
			return messageReader_1.AbstractMessageReader;
		}
	});
	Object.defineProperty(exports, "ReadableStreamMessageReader", {
		enumerable: true,
		get: function() {
			return messageReader_1.ReadableStreamMessageReader;
		}
	});
	var messageWriter_1 = require_messageWriter();
	Object.defineProperty(exports, "MessageWriter", {
		enumerable: true,
		get: function() {
			return messageWriter_1.MessageWriter;
		}
	});
	Object.defineProperty(exports, "AbstractMessageWriter", {
		enumerable: true,
		get: function() {
			return messageWriter_1.AbstractMessageWriter;
		}
	});
	Object.defineProperty(exports, "WriteableStreamMessageWriter", {
		enumerable: true,
		get: function() {
			return messageWriter_1.WriteableStreamMessageWriter;
		}
	});
	var messageBuffer_1 = require_messageBuffer();
	Object.defineProperty(exports, "AbstractMessageBuffer", {
		enumerable: true,
		get: function() {
			return messageBuffer_1.AbstractMessageBuffer;
		}
	});
	var connection_1 = require_connection$1();
	Object.defineProperty(exports, "ConnectionStrategy", {
		enumerable: true,
		get: function() {
			return connection_1.ConnectionStrategy;
		}
	});
	Object.defineProperty(exports, "ConnectionOptions", {
		enumerable: true,
		get: function() {
			return connection_1.ConnectionOptions;
		}
	});
	Object.defineProperty(exports, "NullLogger", {
		enumerable: true,
		get: function() {
			return connection_1.NullLogger;
		}
	});
	Object.defineProperty(exports, "createMessageConnection", {
		enumerable: true,
		get: function() {
			return connection_1.createMessageConnection;
		}
	});
	Object.defineProperty(exports, "ProgressToken", {
		enumerable: true,
		get: function() {
			return connection_1.ProgressToken;
		}
	});
	Object.defineProperty(exports, "ProgressType", {
		enumerable: true,
		get: function() {
			return connection_1.ProgressType;
		}
	});
	Object.defineProperty(exports, "Trace", {
		enumerable: true,
		get: function() {
			return connection_1.Trace;
		}
	});
	Object.defineProperty(exports, "TraceValue", {
		enumerable: true,
		get: function() {
			return connection_1.TraceValue;
		}
	});
	Object.defineProperty(exports, "TraceFormat", {
		enumerable: true,
		get: function() {
			return connection_1.TraceFormat;
		}
	});
	Object.defineProperty(exports, "SetTraceNotification", {
		enumerable: true,
		get: function() {
			return connection_1.SetTraceNotification;
		}
	});
	Object.defineProperty(exports, "LogTraceNotification", {
		enumerable: true,
		get: function() {
			return connection_1.LogTraceNotification;
		}
	});
	Object.defineProperty(exports, "ConnectionErrors", {
		enumerable: true,
		get: function() {
			return connection_1.ConnectionErrors;
		}
	});
	Object.defineProperty(exports, "ConnectionError", {
		enumerable: true,
		get: function() {
			return connection_1.ConnectionError;
		}
	});
	Object.defineProperty(exports, "CancellationReceiverStrategy", {
		enumerable: true,
		get: function() {
			return connection_1.CancellationReceiverStrategy;
		}
	});
	Object.defineProperty(exports, "IdCancellationReceiverStrategy", {
		enumerable: true,
		get: function() {
			return connection_1.IdCancellationReceiverStrategy;
		}
	});
	Object.defineProperty(exports, "RequestCancellationReceiverStrategy", {
		enumerable: true,
		get: function() {
			return connection_1.RequestCancellationReceiverStrategy;
		}
	});
	Object.defineProperty(exports, "CancellationSenderStrategy", {
		enumerable: true,
		get: function() {
			return connection_1.CancellationSenderStrategy;
		}
	});
	Object.defineProperty(exports, "CancellationStrategy", {
		enumerable: true,
		get: function() {
			return connection_1.CancellationStrategy;
		}
	});
	Object.defineProperty(exports, "MessageStrategy", {
		enumerable: true,
		get: function() {
			return connection_1.MessageStrategy;
		}
	});
	Object.defineProperty(exports, "TraceValues", {
		enumerable: true,
		get: function() {
			return connection_1.TraceValues;
		}
	});
	exports.RAL = __importDefault(require_ral()).default;
}));
// node_modules/vscode-languageserver-types/lib/esm/main.js
var main_exports$1 = /* @__PURE__ */ __exportAll({
	AnnotatedTextEdit: () => AnnotatedTextEdit,
	ApplyKind: () => ApplyKind,
	ChangeAnnotation: () => ChangeAnnotation,
	ChangeAnnotationIdentifier: () => ChangeAnnotationIdentifier,
	CodeAction: () => CodeAction,
	CodeActionContext: () => CodeActionContext,
	CodeActionKind: () => CodeActionKind,
	CodeActionTag: () => CodeActionTag,
	CodeActionTriggerKind: () => CodeActionTriggerKind,
	CodeDescription: () => CodeDescription,
	CodeLens: () => CodeLens,
	Color: () => Color,
	ColorInformation: () => ColorInformation,
	ColorPresentation: () => ColorPresentation,
	Command: () => Command,
	CompletionItem: () => CompletionItem,
	CompletionItemKind: () => CompletionItemKind,
	CompletionItemLabelDetails: () => CompletionItemLabelDetails,
	CompletionItemTag: () => CompletionItemTag,
	CompletionList: () => CompletionList,
	CreateFile: () => CreateFile,
	DeleteFile: () => DeleteFile,
	Diagnostic: () => Diagnostic,
	DiagnosticRelatedInformation: () => DiagnosticRelatedInformation,
	DiagnosticSeverity: () => DiagnosticSeverity,
	DiagnosticTag: () => DiagnosticTag,
	DocumentHighlight: () => DocumentHighlight,
	DocumentHighlightKind: () => DocumentHighlightKind,
	DocumentLink: () => DocumentLink,
	DocumentSymbol: () => DocumentSymbol,
	DocumentUri: () => DocumentUri,
	EOL: () => EOL,
	FoldingRange: () => FoldingRange,
	FoldingRangeKind: () => FoldingRangeKind,
	FormattingOptions: () => FormattingOptions,
	Hover: () => Hover,
	InlayHint: () => InlayHint,
	InlayHintKind: () => InlayHintKind,
	InlayHintLabelPart: () => InlayHintLabelPart,
	InlineCompletionContext: () => InlineCompletionContext,
	InlineCompletionItem: () => InlineCompletionItem,
	InlineCompletionList: () => InlineCompletionList,
	InlineCompletionTriggerKind: () => InlineCompletionTriggerKind,
	InlineValueContext: () => InlineValueContext,
	InlineValueEvaluatableExpression: () => InlineValueEvaluatableExpression,
	InlineValueText: () => InlineValueText,
	InlineValueVariableLookup: () => InlineValueVariableLookup,
	InsertReplaceEdit: () => InsertReplaceEdit,
	InsertTextFormat: () => InsertTextFormat,
	InsertTextMode: () => InsertTextMode,
	LanguageKind: () => LanguageKind,
	Location: () => Location,
	LocationLink: () => LocationLink,
	MarkedString: () => MarkedString,
	MarkupContent: () => MarkupContent,
	MarkupKind: () => MarkupKind,
	OptionalVersionedTextDocumentIdentifier: () => OptionalVersionedTextDocumentIdentifier,
	ParameterInformation: () => ParameterInformation,
	Position: () => Position,
	Range: () => Range,
	RenameFile: () => RenameFile,
	SelectedCompletionInfo: () => SelectedCompletionInfo,
	SelectionRange: () => SelectionRange,
	SemanticTokenModifiers: () => SemanticTokenModifiers,
	SemanticTokenTypes: () => SemanticTokenTypes,
	SemanticTokens: () => SemanticTokens,
	SignatureInformation: () => SignatureInformation,
	SnippetTextEdit: () => SnippetTextEdit,
	StringValue: () => StringValue,
	SymbolInformation: () => SymbolInformation,
	SymbolKind: () => SymbolKind,
	SymbolTag: () => SymbolTag,
	TextDocument: () => TextDocument$1,
	TextDocumentEdit: () => TextDocumentEdit,
	TextDocumentIdentifier: () => TextDocumentIdentifier,
	TextDocumentItem: () => TextDocumentItem,
	TextEdit: () => TextEdit,
	URI: () => URI,
	VersionedTextDocumentIdentifier: () => VersionedTextDocumentIdentifier,
	WorkspaceChange: () => WorkspaceChange,
	WorkspaceEdit: () => WorkspaceEdit,
	WorkspaceFolder: () => WorkspaceFolder,
	WorkspaceSymbol: () => WorkspaceSymbol,
	integer: () => integer,
	uinteger: () => uinteger
});
var DocumentUri, URI, integer, uinteger, Position, Range, Location, LocationLink, Color, ColorInformation, ColorPresentation, FoldingRangeKind, FoldingRange, DiagnosticRelatedInformation, DiagnosticSeverity, DiagnosticTag, CodeDescription, Diagnostic, Command, TextEdit, ChangeAnnotation, ChangeAnnotationIdentifier, AnnotatedTextEdit, TextDocumentEdit, CreateFile, RenameFile, DeleteFile, WorkspaceEdit, TextEditChangeImpl, SnippetTextEdit, ChangeAnnotations, WorkspaceChange, TextDocumentIdentifier, VersionedTextDocumentIdentifier, OptionalVersionedTextDocumentIdentifier, LanguageKind, TextDocumentItem, MarkupKind, MarkupContent, CompletionItemKind, InsertTextFormat, CompletionItemTag, InsertReplaceEdit, InsertTextMode, ApplyKind, CompletionItemLabelDetails, CompletionItem, CompletionList, MarkedString, Hover, ParameterInformation, SignatureInformation, DocumentHighlightKind, DocumentHighlight, SymbolKind, SymbolTag, SymbolInformation, WorkspaceSymbol, DocumentSymbol, CodeActionKind, CodeActionTriggerKind, CodeActionContext, CodeActionTag, CodeAction, CodeLens, FormattingOptions, DocumentLink, SelectionRange, SemanticTokenTypes, SemanticTokenModifiers, SemanticTokens, InlineValueText, InlineValueVariableLookup, InlineValueEvaluatableExpression, InlineValueContext, InlayHintKind, InlayHintLabelPart, InlayHint, StringValue, InlineCompletionItem, InlineCompletionList, InlineCompletionTriggerKind, SelectedCompletionInfo, InlineCompletionContext, WorkspaceFolder, EOL, TextDocument$1, FullTextDocument$1, Is;
var init_main$1 = __esmMin((() => {
	(function(DocumentUri) {
		function is(value) {
			return typeof value === "string";
		}
		DocumentUri.is = is;
	})(DocumentUri || (DocumentUri = {}));
	(function(URI) {
		function is(value) {
			return typeof value === "string";
		}
		URI.is = is;
	})(URI || (URI = {}));
	(function(integer) {
		integer.MIN_VALUE = -2147483648;
		integer.MAX_VALUE = 2147483647;
		function is(value) {
			return typeof value === "number" && integer.MIN_VALUE <= value && value <= integer.MAX_VALUE;
		}
		integer.is = is;
	})(integer || (integer = {}));
	(function(uinteger) {
		uinteger.MIN_VALUE = 0;
		uinteger.MAX_VALUE = 2147483647;
		function is(value) {
			return typeof value === "number" && uinteger.MIN_VALUE <= value && value <= uinteger.MAX_VALUE;
		}
		uinteger.is = is;
	})(uinteger || (uinteger = {}));
	(function(Position) {
		/**
		* Creates a new Position literal from the given line and character.
		* @param line The position's line.
		* @param character The position's character.
		*/
		function create(line, character) {
			if (line === Number.MAX_VALUE) line = uinteger.MAX_VALUE;
			if (character === Number.MAX_VALUE) character = uinteger.MAX_VALUE;
			return {
				line,
				character
			};
		}
		Position.create = create;
		/**
		* Checks whether the given literal conforms to the {@link Position} interface.
		*/
		function is(value) {
			const candidate = value;
			return Is.objectLiteral(candidate) && Is.uinteger(candidate.line) && Is.uinteger(candidate.character);
		}
		Position.is = is;
	})(Position || (Position = {}));
	(function(Range) {
		function create(one, two, three, four) {
			if (Is.uinteger(one) && Is.uinteger(two) && Is.uinteger(three) && Is.uinteger(four)) return {
				start: Position.create(one, two),
				end: Position.create(three, four)
			};
			else if (Position.is(one) && Position.is(two)) return {
				start: one,
				end: two
			};
			else throw new Error(`Range#create called with invalid arguments[${one}, ${two}, ${three}, ${four}]`);
		}
		Range.create = create;
		/**
		* Checks whether the given literal conforms to the {@link Range} interface.
		*/
		function is(value) {
			const candidate = value;
			return Is.objectLiteral(candidate) && Position.is(candidate.start) && Position.is(candidate.end);
		}
		Range.is = is;
	})(Range || (Range = {}));
	(function(Location) {
		/**
		* Creates a Location literal.
		* @param uri The location's uri.
		* @param range The location's range.
		*/
		function create(uri, range) {
			return {
				uri,
				range
			};
		}
		Location.create = create;
		/**
		* Checks whether the given literal conforms to the {@link Location} interface.
		*/
		function is(value) {
			const candidate = value;
			return Is.objectLiteral(candidate) && Range.is(candidate.range) && (Is.string(candidate.uri) || Is.undefined(candidate.uri));
		}
		Location.is = is;
	})(Location || (Location = {}));
	(function(LocationLink) {
		/**
		* Creates a LocationLink literal.
		* @param targetUri The definition's uri.
		* @param targetRange The full range of the definition.
		* @param targetSelectionRange The span of the symbol definition at the target.
		* @param originSelectionRange The span of the symbol being defined in the originating source file.
		*/
		function create(targetUri, targetRange, targetSelectionRange, originSelectionRange) {
			return {
				targetUri,
				targetRange,
				targetSelectionRange,
				originSelectionRange
			};
		}
		LocationLink.create = create;
		/**
		* Checks whether the given literal conforms to the {@link LocationLink} interface.
		*/
		function is(value) {
			const candidate = value;
			return Is.objectLiteral(candidate) && Range.is(candidate.targetRange) && Is.string(candidate.targetUri) && Range.is(candidate.targetSelectionRange) && (Range.is(candidate.originSelectionRange) || Is.undefined(candidate.originSelectionRange));
		}
		LocationLink.is = is;
	})(LocationLink || (LocationLink = {}));
	(function(Color) {
		/**
		* Creates a new Color literal.
		*/
		function create(red, green, blue, alpha) {
			return {
				red,
				green,
				blue,
				alpha
			};
		}
		Color.create = create;
		/**
		* Checks whether the given literal conforms to the {@link Color} interface.
		*/
		function is(value) {
			const candidate = value;
			return Is.objectLiteral(candidate) && Is.numberRange(candidate.red, 0, 1) && Is.numberRange(candidate.green, 0, 1) && Is.numberRange(candidate.blue, 0, 1) && Is.numberRange(candidate.alpha, 0, 1);
		}
		Color.is = is;
	})(Color || (Color = {}));
	(function(ColorInformation) {
		/**
		* Creates a new ColorInformation literal.
		*/
		function create(range, color) {
			return {
				range,
				color
			};
		}
		ColorInformation.create = create;
		/**
		* Checks whether the given literal conforms to the {@link ColorInformation} interface.
		*/
		function is(value) {
			const candidate = value;
			return Is.objectLiteral(candidate) && Range.is(candidate.range) && Color.is(candidate.color);
		}
		ColorInformation.is = is;
	})(ColorInformation || (ColorInformation = {}));
	(function(ColorPresentation) {
		/**
		* Creates a new ColorInformation literal.
		*/
		function create(label, textEdit, additionalTextEdits) {
			return {
				label,
				textEdit,
				additionalTextEdits
			};
		}
		ColorPresentation.create = create;
		/**
		* Checks whether the given literal conforms to the {@link ColorInformation} interface.
		*/
		function is(value) {
			const candidate = value;
			return Is.objectLiteral(candidate) && Is.string(candidate.label) && (Is.undefined(candidate.textEdit) || TextEdit.is(candidate.textEdit)) && (Is.undefined(candidate.additionalTextEdits) || Is.typedArray(candidate.additionalTextEdits, TextEdit.is));
		}
		ColorPresentation.is = is;
	})(ColorPresentation || (ColorPresentation = {}));
	(function(FoldingRangeKind) {
		/**
		* Folding range for a comment
		*/
		FoldingRangeKind.Comment = "comment";
		/**
		* Folding range for an import or include
		*/
		FoldingRangeKind.Imports = "imports";
		/**
		* Folding range for a region (e.g. `#region`)
		*/
		FoldingRangeKind.Region = "region";
	})(FoldingRangeKind || (FoldingRangeKind = {}));
	(function(FoldingRange) {
		/**
		* Creates a new FoldingRange literal.
		*/
		function create(startLine, endLine, startCharacter, endCharacter, kind, collapsedText) {
			const result = {
				startLine,
				endLine
			};
			if (Is.defined(startCharacter)) result.startCharacter = startCharacter;
			if (Is.defined(endCharacter)) result.endCharacter = endCharacter;
			if (Is.defined(kind)) result.kind = kind;
			if (Is.defined(collapsedText)) result.collapsedText = collapsedText;
			return result;
		}
		FoldingRange.create = create;
		/**
		* Checks whether the given literal conforms to the {@link FoldingRange} interface.
		*/
		function is(value) {
			const candidate = value;
			return Is.objectLiteral(candidate) && Is.uinteger(candidate.startLine) && Is.uinteger(candidate.endLine) && (Is.undefined(candidate.startCharacter) || Is.uinteger(candidate.startCharacter)) && (Is.undefined(candidate.endCharacter) || Is.uinteger(candidate.endCharacter)) && (Is.undefined(candidate.kind) || Is.string(candidate.kind));
		}
		FoldingRange.is = is;
	})(FoldingRange || (FoldingRange = {}));
	(function(DiagnosticRelatedInformation) {
		/**
		* Creates a new DiagnosticRelatedInformation literal.
		*/
		function create(location, message) {
			return {
				location,
				message
			};
		}
		DiagnosticRelatedInformation.create = create;
		/**
		* Checks whether the given literal conforms to the {@link DiagnosticRelatedInformation} interface.
		*/
		function is(value) {
			const candidate = value;
			return Is.defined(candidate) && Location.is(candidate.location) && Is.string(candidate.message);
		}
		DiagnosticRelatedInformation.is = is;
	})(DiagnosticRelatedInformation || (DiagnosticRelatedInformation = {}));
	(function(DiagnosticSeverity) {
		/**
		* Reports an error.
		*/
		DiagnosticSeverity.Error = 1;
		/**
		* Reports a warning.
		*/
		DiagnosticSeverity.Warning = 2;
		/**
		* Reports an information.
		*/
		DiagnosticSeverity.Information = 3;
		/**
		* Reports a hint.
		*/
		DiagnosticSeverity.Hint = 4;
	})(DiagnosticSeverity || (DiagnosticSeverity = {}));
	(function(DiagnosticTag) {
		/**
		* Unused or unnecessary code.
		*
		* Clients are allowed to render diagnostics with this tag faded out instead of having
		* an error squiggle.
		*/
		DiagnosticTag.Unnecessary = 1;
		/**
		* Deprecated or obsolete code.
		*
		* Clients are allowed to rendered diagnostics with this tag strike through.
		*/
		DiagnosticTag.Deprecated = 2;
	})(DiagnosticTag || (DiagnosticTag = {}));
	(function(CodeDescription) {
		function is(value) {
			const candidate = value;
			return Is.objectLiteral(candidate) && Is.string(candidate.href);
		}
		CodeDescription.is = is;
	})(CodeDescription || (CodeDescription = {}));
	(function(Diagnostic) {
		/**
		* Creates a new Diagnostic literal.
		*/
		function create(range, message, severity, code, source, relatedInformation) {
			const result = {
				range,
				message
			};
			if (Is.defined(severity)) result.severity = severity;
			if (Is.defined(code)) result.code = code;
			if (Is.defined(source)) result.source = source;
			if (Is.defined(relatedInformation)) result.relatedInformation = relatedInformation;
			return result;
		}
		Diagnostic.create = create;
		/**
		* Checks whether the given literal conforms to the {@link Diagnostic} interface.
		*/
		function is(value) {
			var _a;
			const candidate = value;
			return Is.defined(candidate) && Range.is(candidate.range) && (Is.string(candidate.message) || MarkupContent.is(candidate.message)) && (Is.number(candidate.severity) || Is.undefined(candidate.severity)) && (Is.integer(candidate.code) || Is.string(candidate.code) || Is.undefined(candidate.code)) && (Is.undefined(candidate.codeDescription) || Is.string((_a = candidate.codeDescription) === null || _a === void 0 ? void 0 : _a.href)) && (Is.string(candidate.source) || Is.undefined(candidate.source)) && (Is.undefined(candidate.relatedInformation) || Is.typedArray(candidate.relatedInformation, DiagnosticRelatedInformation.is));
		}
		Diagnostic.is = is;
		/**
		* Checks whether the given diagnostic's message conforms to the 3.17.0
		* version of the protocol where the message is a string.
		*
		* @param value the diagnostic
		* @returns true if the diagnostic's message is a string, false otherwise.
		*/
		function is3_17(value) {
			return Is.string(value.message);
		}
		Diagnostic.is3_17 = is3_17;
		/**
		* Gets the message string of a diagnostic. If the message is already a
		* string, it is returned as is. If the message is a MarkupContent,
		* the value of the MarkupContent is returned. Otherwise an error is thrown.
		*
		* @param diagnostic the diagnostic to get the message string from.
		* @returns the message string of the given diagnostic.
		*/
		function getMessageString(diagnostic) {
			if (Is.string(diagnostic.message)) return diagnostic.message;
			else if (MarkupContent.is(diagnostic.message)) return diagnostic.message.value;
			else throw new Error(`Unknown message type ${typeof diagnostic.message}`);
		}
		Diagnostic.getMessageString = getMessageString;
	})(Diagnostic || (Diagnostic = {}));
	(function(Command) {
		/**
		* Creates a new Command literal.
		*/
		function create(title, command, ...args) {
			const result = {
				title,
				command
			};
			if (Is.defined(args) && args.length > 0) result.arguments = args;
			return result;
		}
		Command.create = create;
		/**
		* Checks whether the given literal conforms to the {@link Command} interface.
		*/
		function is(value) {
			const candidate = value;
			return Is.defined(candidate) && Is.string(candidate.title) && (candidate.tooltip === void 0 || Is.string(candidate.tooltip)) && Is.string(candidate.command);
		}
		Command.is = is;
	})(Command || (Command = {}));
	(function(TextEdit) {
		/**
		* Creates a replace text edit.
		* @param range The range of text to be replaced.
		* @param newText The new text.
		*/
		function replace(range, newText) {
			return {
				range,
				newText
			};
		}
		TextEdit.replace = replace;
		/**
		* Creates an insert text edit.
		* @param position The position to insert the text at.
		* @param newText The text to be inserted.
		*/
		function insert(position, newText) {
			return {
				range: {
					start: position,
					end: position
				},
				newText
			};
		}
		TextEdit.insert = insert;
		/**
		* Creates a delete text edit.
		* @param range The range of text to be deleted.
		*/
		function del(range) {
			return {
				range,
				newText: ""
			};
		}
		TextEdit.del = del;
		function is(value) {
			const candidate = value;
			return Is.objectLiteral(candidate) && Is.string(candidate.newText) && Range.is(candidate.range);
		}
		TextEdit.is = is;
	})(TextEdit || (TextEdit = {}));
	(function(ChangeAnnotation) {
		function create(label, needsConfirmation, description) {
			const result = { label };
			if (needsConfirmation !== void 0) result.needsConfirmation = needsConfirmation;
			if (description !== void 0) result.description = description;
			return result;
		}
		ChangeAnnotation.create = create;
		function is(value) {
			const candidate = value;
			return Is.objectLiteral(candidate) && Is.string(candidate.label) && (Is.boolean(candidate.needsConfirmation) || candidate.needsConfirmation === void 0) && (Is.string(candidate.description) || candidate.description === void 0);
		}
		ChangeAnnotation.is = is;
	})(ChangeAnnotation || (ChangeAnnotation = {}));
	(function(ChangeAnnotationIdentifier) {
		function is(value) {
			const candidate = value;
			return Is.string(candidate);
		}
		ChangeAnnotationIdentifier.is = is;
	})(ChangeAnnotationIdentifier || (ChangeAnnotationIdentifier = {}));
	(function(AnnotatedTextEdit) {
		/**
		* Creates an annotated replace text edit.
		*
		* @param range The range of text to be replaced.
		* @param newText The new text.
		* @param annotation The annotation.
		*/
		function replace(range, newText, annotation) {
			return {
				range,
				newText,
				annotationId: annotation
			};
		}
		AnnotatedTextEdit.replace = replace;
		/**
		* Creates an annotated insert text edit.
		*
		* @param position The position to insert the text at.
		* @param newText The text to be inserted.
		* @param annotation The annotation.
		*/
		function insert(position, newText, annotation) {
			return {
				range: {
					start: position,
					end: position
				},
				newText,
				annotationId: annotation
			};
		}
		AnnotatedTextEdit.insert = insert;
		/**
		* Creates an annotated delete text edit.
		*
		* @param range The range of text to be deleted.
		* @param annotation The annotation.
		*/
		function del(range, annotation) {
			return {
				range,
				newText: "",
				annotationId: annotation
			};
		}
		AnnotatedTextEdit.del = del;
		function is(value) {
			const candidate = value;
			return TextEdit.is(candidate) && (ChangeAnnotation.is(candidate.annotationId) || ChangeAnnotationIdentifier.is(candidate.annotationId));
		}
		AnnotatedTextEdit.is = is;
	})(AnnotatedTextEdit || (AnnotatedTextEdit = {}));
	(function(TextDocumentEdit) {
		/**
		* Creates a new `TextDocumentEdit`
		*/
		function create(textDocument, edits) {
			return {
				textDocument,
				edits
			};
		}
		TextDocumentEdit.create = create;
		function is(value) {
			const candidate = value;
			return Is.defined(candidate) && OptionalVersionedTextDocumentIdentifier.is(candidate.textDocument) && Array.isArray(candidate.edits);
		}
		TextDocumentEdit.is = is;
	})(TextDocumentEdit || (TextDocumentEdit = {}));
	(function(CreateFile) {
		function create(uri, options, annotation) {
			const result = {
				kind: "create",
				uri
			};
			if (options !== void 0 && (options.overwrite !== void 0 || options.ignoreIfExists !== void 0)) result.options = options;
			if (annotation !== void 0) result.annotationId = annotation;
			return result;
		}
		CreateFile.create = create;
		function is(value) {
			const candidate = value;
			return candidate && candidate.kind === "create" && Is.string(candidate.uri) && (candidate.options === void 0 || (candidate.options.overwrite === void 0 || Is.boolean(candidate.options.overwrite)) && (candidate.options.ignoreIfExists === void 0 || Is.boolean(candidate.options.ignoreIfExists))) && (candidate.annotationId === void 0 || ChangeAnnotationIdentifier.is(candidate.annotationId));
		}
		CreateFile.is = is;
	})(CreateFile || (CreateFile = {}));
	(function(RenameFile) {
		function create(oldUri, newUri, options, annotation) {
			const result = {
				kind: "rename",
				oldUri,
				newUri
			};
			if (options !== void 0 && (options.overwrite !== void 0 || options.ignoreIfExists !== void 0)) result.options = options;
			if (annotation !== void 0) result.annotationId = annotation;
			return result;
		}
		RenameFile.create = create;
		function is(value) {
			const candidate = value;
			return candidate && candidate.kind === "rename" && Is.string(candidate.oldUri) && Is.string(candidate.newUri) && (candidate.options === void 0 || (candidate.options.overwrite === void 0 || Is.boolean(candidate.options.overwrite)) && (candidate.options.ignoreIfExists === void 0 || Is.boolean(candidate.options.ignoreIfExists))) && (candidate.annotationId === void 0 || ChangeAnnotationIdentifier.is(candidate.annotationId));
		}
		RenameFile.is = is;
	})(RenameFile || (RenameFile = {}));
	(function(DeleteFile) {
		function create(uri, options, annotation) {
			const result = {
				kind: "delete",
				uri
			};
			if (options !== void 0 && (options.recursive !== void 0 || options.ignoreIfNotExists !== void 0)) result.options = options;
			if (annotation !== void 0) result.annotationId = annotation;
			return result;
		}
		DeleteFile.create = create;
		function is(value) {
			const candidate = value;
			return candidate && candidate.kind === "delete" && Is.string(candidate.uri) && (candidate.options === void 0 || (candidate.options.recursive === void 0 || Is.boolean(candidate.options.recursive)) && (candidate.options.ignoreIfNotExists === void 0 || Is.boolean(candidate.options.ignoreIfNotExists))) && (candidate.annotationId === void 0 || ChangeAnnotationIdentifier.is(candidate.annotationId));
		}
		DeleteFile.is = is;
	})(DeleteFile || (DeleteFile = {}));
	(function(WorkspaceEdit) {
		function is(value) {
			const candidate = value;
			return candidate && (candidate.changes !== void 0 || candidate.documentChanges !== void 0) && (candidate.documentChanges === void 0 || candidate.documentChanges.every((change) => {
				if (Is.string(change.kind)) return CreateFile.is(change) || RenameFile.is(change) || DeleteFile.is(change);
				else return TextDocumentEdit.is(change);
			}));
		}
		WorkspaceEdit.is = is;
	})(WorkspaceEdit || (WorkspaceEdit = {}));
	TextEditChangeImpl = class {
		constructor(edits, changeAnnotations) {
			this.edits = edits;
			this.changeAnnotations = changeAnnotations;
		}
		insert(position, newText, annotation) {
			let edit;
			let id;
			if (annotation === void 0) edit = TextEdit.insert(position, newText);
			else if (ChangeAnnotationIdentifier.is(annotation)) {
				id = annotation;
				edit = AnnotatedTextEdit.insert(position, newText, annotation);
			} else {
				this.assertChangeAnnotations(this.changeAnnotations);
				id = this.changeAnnotations.manage(annotation);
				edit = AnnotatedTextEdit.insert(position, newText, id);
			}
			this.edits.push(edit);
			if (id !== void 0) return id;
		}
		replace(range, newText, annotation) {
			let edit;
			let id;
			if (annotation === void 0) edit = TextEdit.replace(range, newText);
			else if (ChangeAnnotationIdentifier.is(annotation)) {
				id = annotation;
				edit = AnnotatedTextEdit.replace(range, newText, annotation);
			} else {
				this.assertChangeAnnotations(this.changeAnnotations);
				id = this.changeAnnotations.manage(annotation);
				edit = AnnotatedTextEdit.replace(range, newText, id);
			}
			this.edits.push(edit);
			if (id !== void 0) return id;
		}
		delete(range, annotation) {
			let edit;
			let id;
			if (annotation === void 0) edit = TextEdit.del(range);
			else if (ChangeAnnotationIdentifier.is(annotation)) {
				id = annotation;
				edit = AnnotatedTextEdit.del(range, annotation);
			} else {
				this.assertChangeAnnotations(this.changeAnnotations);
				id = this.changeAnnotations.manage(annotation);
				edit = AnnotatedTextEdit.del(range, id);
			}
			this.edits.push(edit);
			if (id !== void 0) return id;
		}
		add(edit) {
			this.edits.push(edit);
		}
		all() {
			return this.edits;
		}
		clear() {
			this.edits.splice(0, this.edits.length);
		}
		assertChangeAnnotations(value) {
			if (value === void 0) throw new Error(`Text edit change is not configured to manage change annotations.`);
		}
	};
	(function(SnippetTextEdit) {
		function is(value) {
			const candidate = value;
			return Is.objectLiteral(candidate) && Range.is(candidate.range) && StringValue.isSnippet(candidate.snippet) && (candidate.annotationId === void 0 || ChangeAnnotation.is(candidate.annotationId) || ChangeAnnotationIdentifier.is(candidate.annotationId));
		}
		SnippetTextEdit.is = is;
	})(SnippetTextEdit || (SnippetTextEdit = {}));
	ChangeAnnotations = class {
		constructor(annotations) {
			this._annotations = annotations === void 0 ? Object.create(null) : annotations;
			this._counter = 0;
			this._size = 0;
		}
		all() {
			return this._annotations;
		}
		get size() {
			return this._size;
		}
		manage(idOrAnnotation, annotation) {
			let id;
			if (ChangeAnnotationIdentifier.is(idOrAnnotation)) id = idOrAnnotation;
			else {
				id = this.nextId();
				annotation = idOrAnnotation;
			}
			if (this._annotations[id] !== void 0) throw new Error(`Id ${id} is already in use.`);
			if (annotation === void 0) throw new Error(`No annotation provided for id ${id}`);
			this._annotations[id] = annotation;
			this._size++;
			return id;
		}
		nextId() {
			this._counter++;
			return this._counter.toString();
		}
	};
	WorkspaceChange = class {
		constructor(workspaceEdit) {
			this._textEditChanges = Object.create(null);
			if (workspaceEdit !== void 0) {
				this._workspaceEdit = workspaceEdit;
				if (workspaceEdit.documentChanges) {
					this._changeAnnotations = new ChangeAnnotations(workspaceEdit.changeAnnotations);
					workspaceEdit.changeAnnotations = this._changeAnnotations.all();
					workspaceEdit.documentChanges.forEach((change) => {
						if (TextDocumentEdit.is(change)) {
							const textEditChange = new TextEditChangeImpl(change.edits, this._changeAnnotations);
							this._textEditChanges[change.textDocument.uri] = textEditChange;
						}
					});
				} else if (workspaceEdit.changes) Object.keys(workspaceEdit.changes).forEach((key) => {
					const textEditChange = new TextEditChangeImpl(workspaceEdit.changes[key]);
					this._textEditChanges[key] = textEditChange;
				});
			} else this._workspaceEdit = {};
		}
		/**
		* Returns the underlying {@link WorkspaceEdit} literal
		* use to be returned from a workspace edit operation like rename.
		*/
		get edit() {
			this.initDocumentChanges();
			if (this._changeAnnotations !== void 0) {
				if (this._changeAnnotations.size === 0) this._workspaceEdit.changeAnnotations = void 0;
				else this._workspaceEdit.changeAnnotations = this._changeAnnotations.all();
			}
			return this._workspaceEdit;
		}
		getTextEditChange(key) {
			if (OptionalVersionedTextDocumentIdentifier.is(key)) {
				this.initDocumentChanges();
				if (this._workspaceEdit.documentChanges === void 0) throw new Error("Workspace edit is not configured for document changes.");
				const textDocument = {
					uri: key.uri,
					version: key.version
				};
				let result = this._textEditChanges[textDocument.uri];
				if (!result) {
					const edits = [];
					const textDocumentEdit = {
						textDocument,
						edits
					};
					this._workspaceEdit.documentChanges.push(textDocumentEdit);
					result = new TextEditChangeImpl(edits, this._changeAnnotations);
					this._textEditChanges[textDocument.uri] = result;
				}
				return result;
			} else {
				this.initChanges();
				if (this._workspaceEdit.changes === void 0) throw new Error("Workspace edit is not configured for normal text edit changes.");
				let result = this._textEditChanges[key];
				if (!result) {
					const edits = [];
					this._workspaceEdit.changes[key] = edits;
					result = new TextEditChangeImpl(edits);
					this._textEditChanges[key] = result;
				}
				return result;
			}
		}
		initDocumentChanges() {
			if (this._workspaceEdit.documentChanges === void 0 && this._workspaceEdit.changes === void 0) {
				this._changeAnnotations = new ChangeAnnotations();
				this._workspaceEdit.documentChanges = [];
				this._workspaceEdit.changeAnnotations = this._changeAnnotations.all();
			}
		}
		initChanges() {
			if (this._workspaceEdit.documentChanges === void 0 && this._workspaceEdit.changes === void 0) this._workspaceEdit.changes = Object.create(null);
		}
		createFile(uri, optionsOrAnnotation, options) {
			this.initDocumentChanges();
			if (this._workspaceEdit.documentChanges === void 0) throw new Error("Workspace edit is not configured for document changes.");
			let annotation;
			if (ChangeAnnotation.is(optionsOrAnnotation) || ChangeAnnotationIdentifier.is(optionsOrAnnotation)) annotation = optionsOrAnnotation;
			else options = optionsOrAnnotation;
			let operation;
			let id;
			if (annotation === void 0) operation = CreateFile.create(uri, options);
			else {
				id = ChangeAnnotationIdentifier.is(annotation) ? annotation : this._changeAnnotations.manage(annotation);
				operation = CreateFile.create(uri, options, id);
			}
			this._workspaceEdit.documentChanges.push(operation);
			if (id !== void 0) return id;
		}
		renameFile(oldUri, newUri, optionsOrAnnotation, options) {
			this.initDocumentChanges();
			if (this._workspaceEdit.documentChanges === void 0) throw new Error("Workspace edit is not configured for document changes.");
			let annotation;
			if (ChangeAnnotation.is(optionsOrAnnotation) || ChangeAnnotationIdentifier.is(optionsOrAnnotation)) annotation = optionsOrAnnotation;
			else options = optionsOrAnnotation;
			let operation;
			let id;
			if (annotation === void 0) operation = RenameFile.create(oldUri, newUri, options);
			else {
				id = ChangeAnnotationIdentifier.is(annotation) ? annotation : this._changeAnnotations.manage(annotation);
				operation = RenameFile.create(oldUri, newUri, options, id);
			}
			this._workspaceEdit.documentChanges.push(operation);
			if (id !== void 0) return id;
		}
		deleteFile(uri, optionsOrAnnotation, options) {
			this.initDocumentChanges();
			if (this._workspaceEdit.documentChanges === void 0) throw new Error("Workspace edit is not configured for document changes.");
			let annotation;
			if (ChangeAnnotation.is(optionsOrAnnotation) || ChangeAnnotationIdentifier.is(optionsOrAnnotation)) annotation = optionsOrAnnotation;
			else options = optionsOrAnnotation;
			let operation;
			let id;
			if (annotation === void 0) operation = DeleteFile.create(uri, options);
			else {
				id = ChangeAnnotationIdentifier.is(annotation) ? annotation : this._changeAnnotations.manage(annotation);
				operation = DeleteFile.create(uri, options, id);
			}
			this._workspaceEdit.documentChanges.push(operation);
			if (id !== void 0) return id;
		}
	};
	(function(TextDocumentIdentifier) {
		/**
		* Creates a new TextDocumentIdentifier literal.
		* @param uri The document's uri.
		*/
		function create(uri) {
			return { uri };
		}
		TextDocumentIdentifier.create = create;
		/**
		* Checks whether the given literal conforms to the {@link TextDocumentIdentifier} interface.
		*/
		function is(value) {
			const candidate = value;
			return Is.defined(candidate) && Is.string(candidate.uri);
		}
		TextDocumentIdentifier.is = is;
	})(TextDocumentIdentifier || (TextDocumentIdentifier = {}));
	(function(VersionedTextDocumentIdentifier) {
		/**
		* Creates a new VersionedTextDocumentIdentifier literal.
		* @param uri The document's uri.
		* @param version The document's version.
		*/
		function create(uri, version) {
			return {
				uri,
				version
			};
		}
		VersionedTextDocumentIdentifier.create = create;
		/**
		* Checks whether the given literal conforms to the {@link VersionedTextDocumentIdentifier} interface.
		*/
		function is(value) {
			const candidate = value;
			return Is.defined(candidate) && Is.string(candidate.uri) && Is.integer(candidate.version);
		}
		VersionedTextDocumentIdentifier.is = is;
	})(VersionedTextDocumentIdentifier || (VersionedTextDocumentIdentifier = {}));
	(function(OptionalVersionedTextDocumentIdentifier) {
		/**
		* Creates a new OptionalVersionedTextDocumentIdentifier literal.
		* @param uri The document's uri.
		* @param version The document's version.
		*/
		function create(uri, version) {
			return {
				uri,
				version
			};
		}
		OptionalVersionedTextDocumentIdentifier.create = create;
		/**
		* Checks whether the given literal conforms to the {@link OptionalVersionedTextDocumentIdentifier} interface.
		*/
		function is(value) {
			const candidate = value;
			return Is.defined(candidate) && Is.string(candidate.uri) && (candidate.version === null || Is.integer(candidate.version));
		}
		OptionalVersionedTextDocumentIdentifier.is = is;
	})(OptionalVersionedTextDocumentIdentifier || (OptionalVersionedTextDocumentIdentifier = {}));
	(function(LanguageKind) {
		LanguageKind.ABAP = "abap";
		LanguageKind.WindowsBat = "bat";
		LanguageKind.BibTeX = "bibtex";
		LanguageKind.Clojure = "clojure";
		LanguageKind.Coffeescript = "coffeescript";
		LanguageKind.C = "c";
		LanguageKind.CPP = "cpp";
		LanguageKind.CSharp = "csharp";
		LanguageKind.CSS = "css";
		/**
		* @since 3.18.0
		*/
		LanguageKind.D = "d";
		/**
		* @since 3.18.0
		*/
		LanguageKind.Delphi = "pascal";
		LanguageKind.Diff = "diff";
		LanguageKind.Dart = "dart";
		LanguageKind.Dockerfile = "dockerfile";
		LanguageKind.Elixir = "elixir";
		LanguageKind.Erlang = "erlang";
		LanguageKind.FSharp = "fsharp";
		LanguageKind.GitCommit = "git-commit";
		LanguageKind.GitRebase = "git-rebase";
		LanguageKind.Go = "go";
		LanguageKind.Groovy = "groovy";
		LanguageKind.Handlebars = "handlebars";
		LanguageKind.Haskell = "haskell";
		LanguageKind.HTML = "html";
		LanguageKind.Ini = "ini";
		LanguageKind.Java = "java";
		LanguageKind.JavaScript = "javascript";
		LanguageKind.JavaScriptReact = "javascriptreact";
		LanguageKind.JSON = "json";
		LanguageKind.LaTeX = "latex";
		LanguageKind.Less = "less";
		LanguageKind.Lua = "lua";
		LanguageKind.Makefile = "makefile";
		LanguageKind.Markdown = "markdown";
		LanguageKind.ObjectiveC = "objective-c";
		LanguageKind.ObjectiveCPP = "objective-cpp";
		/**
		* @since 3.18.0
		*/
		LanguageKind.Pascal = "pascal";
		LanguageKind.Perl = "perl";
		LanguageKind.Perl6 = "perl6";
		LanguageKind.PHP = "php";
		LanguageKind.Plaintext = "plaintext";
		LanguageKind.Powershell = "powershell";
		LanguageKind.Pug = "jade";
		LanguageKind.Python = "python";
		LanguageKind.R = "r";
		LanguageKind.Razor = "razor";
		LanguageKind.Ruby = "ruby";
		LanguageKind.Rust = "rust";
		LanguageKind.SCSS = "scss";
		LanguageKind.SASS = "sass";
		LanguageKind.Scala = "scala";
		LanguageKind.ShaderLab = "shaderlab";
		LanguageKind.ShellScript = "shellscript";
		LanguageKind.SQL = "sql";
		LanguageKind.Swift = "swift";
		LanguageKind.TypeScript = "typescript";
		LanguageKind.TypeScriptReact = "typescriptreact";
		LanguageKind.TeX = "tex";
		LanguageKind.VisualBasic = "vb";
		LanguageKind.XML = "xml";
		LanguageKind.XSL = "xsl";
		LanguageKind.YAML = "yaml";
	})(LanguageKind || (LanguageKind = {}));
	(function(TextDocumentItem) {
		/**
		* Creates a new TextDocumentItem literal.
		* @param uri The document's uri.
		* @param languageId The document's language identifier.
		* @param version The document's version number.
		* @param text The document's text.
		*/
		function create(uri, languageId, version, text) {
			return {
				uri,
				languageId,
				version,
				text
			};
		}
		TextDocumentItem.create = create;
		/**
		* Checks whether the given literal conforms to the {@link TextDocumentItem} interface.
		*/
		function is(value) {
			const candidate = value;
			return Is.defined(candidate) && Is.string(candidate.uri) && Is.string(candidate.languageId) && Is.integer(candidate.version) && Is.string(candidate.text);
		}
		TextDocumentItem.is = is;
	})(TextDocumentItem || (TextDocumentItem = {}));
	(function(MarkupKind) {
		/**
		* Plain text is supported as a content format
		*/
		MarkupKind.PlainText = "plaintext";
		/**
		* Markdown is supported as a content format
		*/
		MarkupKind.Markdown = "markdown";
		/**
		* Checks whether the given value is a value of the {@link MarkupKind} type.
		*/
		function is(value) {
			const candidate = value;
			return candidate === MarkupKind.PlainText || candidate === MarkupKind.Markdown;
		}
		MarkupKind.is = is;
	})(MarkupKind || (MarkupKind = {}));
	(function(MarkupContent) {
		/**
		* Checks whether the given value conforms to the {@link MarkupContent} interface.
		*/
		function is(value) {
			const candidate = value;
			return Is.objectLiteral(value) && MarkupKind.is(candidate.kind) && Is.string(candidate.value);
		}
		MarkupContent.is = is;
	})(MarkupContent || (MarkupContent = {}));
	(function(CompletionItemKind) {
		CompletionItemKind.Text = 1;
		CompletionItemKind.Method = 2;
		CompletionItemKind.Function = 3;
		CompletionItemKind.Constructor = 4;
		CompletionItemKind.Field = 5;
		CompletionItemKind.Variable = 6;
		CompletionItemKind.Class = 7;
		CompletionItemKind.Interface = 8;
		CompletionItemKind.Module = 9;
		CompletionItemKind.Property = 10;
		CompletionItemKind.Unit = 11;
		CompletionItemKind.Value = 12;
		CompletionItemKind.Enum = 13;
		CompletionItemKind.Keyword = 14;
		CompletionItemKind.Snippet = 15;
		CompletionItemKind.Color = 16;
		CompletionItemKind.File = 17;
		CompletionItemKind.Reference = 18;
		CompletionItemKind.Folder = 19;
		CompletionItemKind.EnumMember = 20;
		CompletionItemKind.Constant = 21;
		CompletionItemKind.Struct = 22;
		CompletionItemKind.Event = 23;
		CompletionItemKind.Operator = 24;
		CompletionItemKind.TypeParameter = 25;
	})(CompletionItemKind || (CompletionItemKind = {}));
	(function(InsertTextFormat) {
		/**
		* The primary text to be inserted is treated as a plain string.
		*/
		InsertTextFormat.PlainText = 1;
		/**
		* The primary text to be inserted is treated as a snippet.
		*
		* A snippet can define tab stops and placeholders with `$1`, `$2`
		* and `${3:foo}`. `$0` defines the final tab stop, it defaults to
		* the end of the snippet. Placeholders with equal identifiers are linked,
		* that is typing in one will update others too.
		*
		* See also: https://microsoft.github.io/language-server-protocol/specifications/specification-current/#snippet_syntax
		*/
		InsertTextFormat.Snippet = 2;
	})(InsertTextFormat || (InsertTextFormat = {}));
	(function(CompletionItemTag) {
		/**
		* Render a completion as obsolete, usually using a strike-out.
		*/
		CompletionItemTag.Deprecated = 1;
	})(CompletionItemTag || (CompletionItemTag = {}));
	(function(InsertReplaceEdit) {
		/**
		* Creates a new insert / replace edit
		*/
		function create(newText, insert, replace) {
			return {
				newText,
				insert,
				replace
			};
		}
		InsertReplaceEdit.create = create;
		/**
		* Checks whether the given literal conforms to the {@link InsertReplaceEdit} interface.
		*/
		function is(value) {
			const candidate = value;
			return candidate && Is.string(candidate.newText) && Range.is(candidate.insert) && Range.is(candidate.replace);
		}
		InsertReplaceEdit.is = is;
	})(InsertReplaceEdit || (InsertReplaceEdit = {}));
	(function(InsertTextMode) {
		/**
		* The insertion or replace strings is taken as it is. If the
		* value is multi line the lines below the cursor will be
		* inserted using the indentation defined in the string value.
		* The client will not apply any kind of adjustments to the
		* string.
		*/
		InsertTextMode.asIs = 1;
		/**
		* The editor adjusts leading whitespace of new lines so that
		* they match the indentation up to the cursor of the line for
		* which the item is accepted.
		*
		* Consider a line like this: <2tabs><cursor><3tabs>foo. Accepting a
		* multi line completion item is indented using 2 tabs and all
		* following lines inserted will be indented using 2 tabs as well.
		*/
		InsertTextMode.adjustIndentation = 2;
	})(InsertTextMode || (InsertTextMode = {}));
	(function(ApplyKind) {
		/**
		* The value from the individual item (if provided and not `null`) will be
		* used instead of the default.
		*/
		ApplyKind.Replace = 1;
		/**
		* The value from the item will be merged with the default.
		*
		* The specific rules for mergeing values are defined against each field
		* that supports merging.
		*/
		ApplyKind.Merge = 2;
	})(ApplyKind || (ApplyKind = {}));
	(function(CompletionItemLabelDetails) {
		function is(value) {
			const candidate = value;
			return candidate && (Is.string(candidate.detail) || candidate.detail === void 0) && (Is.string(candidate.description) || candidate.description === void 0);
		}
		CompletionItemLabelDetails.is = is;
	})(CompletionItemLabelDetails || (CompletionItemLabelDetails = {}));
	(function(CompletionItem) {
		/**
		* Create a completion item and seed it with a label.
		* @param label The completion item's label
		*/
		function create(label) {
			return { label };
		}
		CompletionItem.create = create;
	})(CompletionItem || (CompletionItem = {}));
	(function(CompletionList) {
		/**
		* Creates a new completion list.
		*
		* @param items The completion items.
		* @param isIncomplete The list is not complete.
		*/
		function create(items, isIncomplete) {
			return {
				items: items ? items : [],
				isIncomplete: !!isIncomplete
			};
		}
		CompletionList.create = create;
	})(CompletionList || (CompletionList = {}));
	(function(MarkedString) {
		/**
		* Creates a marked string from plain text.
		*
		* @param plainText The plain text.
		*/
		function fromPlainText(plainText) {
			return plainText.replace(/[\\`*_{}[\]()#+\-.!]/g, "\\$&");
		}
		MarkedString.fromPlainText = fromPlainText;
		/**
		* Checks whether the given value conforms to the {@link MarkedString} type.
		*/
		function is(value) {
			const candidate = value;
			return Is.string(candidate) || Is.objectLiteral(candidate) && Is.string(candidate.language) && Is.string(candidate.value);
		}
		MarkedString.is = is;
	})(MarkedString || (MarkedString = {}));
	(function(Hover) {
		/**
		* Checks whether the given value conforms to the {@link Hover} interface.
		*/
		function is(value) {
			const candidate = value;
			return !!candidate && Is.objectLiteral(candidate) && (MarkupContent.is(candidate.contents) || MarkedString.is(candidate.contents) || Is.typedArray(candidate.contents, MarkedString.is)) && (value.range === void 0 || Range.is(value.range));
		}
		Hover.is = is;
	})(Hover || (Hover = {}));
	(function(ParameterInformation) {
		/**
		* Creates a new parameter information literal.
		*
		* @param label A label string.
		* @param documentation A doc string.
		*/
		function create(label, documentation) {
			return documentation ? {
				label,
				documentation
			} : { label };
		}
		ParameterInformation.create = create;
	})(ParameterInformation || (ParameterInformation = {}));
	(function(SignatureInformation) {
		function create(label, documentation, ...parameters) {
			const result = { label };
			if (Is.defined(documentation)) result.documentation = documentation;
			if (Is.defined(parameters)) result.parameters = parameters;
			else result.parameters = [];
			return result;
		}
		SignatureInformation.create = create;
	})(SignatureInformation || (SignatureInformation = {}));
	(function(DocumentHighlightKind) {
		/**
		* A textual occurrence.
		*/
		DocumentHighlightKind.Text = 1;
		/**
		* Read-access of a symbol, like reading a variable.
		*/
		DocumentHighlightKind.Read = 2;
		/**
		* Write-access of a symbol, like writing to a variable.
		*/
		DocumentHighlightKind.Write = 3;
	})(DocumentHighlightKind || (DocumentHighlightKind = {}));
	(function(DocumentHighlight) {
		/**
		* Create a DocumentHighlight object.
		* @param range The range the highlight applies to.
		* @param kind The highlight kind
		*/
		function create(range, kind) {
			const result = { range };
			if (Is.number(kind)) result.kind = kind;
			return result;
		}
		DocumentHighlight.create = create;
	})(DocumentHighlight || (DocumentHighlight = {}));
	(function(SymbolKind) {
		SymbolKind.File = 1;
		SymbolKind.Module = 2;
		SymbolKind.Namespace = 3;
		SymbolKind.Package = 4;
		SymbolKind.Class = 5;
		SymbolKind.Method = 6;
		SymbolKind.Property = 7;
		SymbolKind.Field = 8;
		SymbolKind.Constructor = 9;
		SymbolKind.Enum = 10;
		SymbolKind.Interface = 11;
		SymbolKind.Function = 12;
		SymbolKind.Variable = 13;
		SymbolKind.Constant = 14;
		SymbolKind.String = 15;
		SymbolKind.Number = 16;
		SymbolKind.Boolean = 17;
		SymbolKind.Array = 18;
		SymbolKind.Object = 19;
		SymbolKind.Key = 20;
		SymbolKind.Null = 21;
		SymbolKind.EnumMember = 22;
		SymbolKind.Struct = 23;
		SymbolKind.Event = 24;
		SymbolKind.Operator = 25;
		SymbolKind.TypeParameter = 26;
	})(SymbolKind || (SymbolKind = {}));
	(function(SymbolTag) {
		/**
		* Render a symbol as obsolete, usually using a strike-out.
		*/
		SymbolTag.Deprecated = 1;
	})(SymbolTag || (SymbolTag = {}));
	(function(SymbolInformation) {
		/**
		* Creates a new symbol information literal.
		*
		* @param name The name of the symbol.
		* @param kind The kind of the symbol.
		* @param range The range of the location of the symbol.
		* @param uri The resource of the location of symbol.
		* @param containerName The name of the symbol containing the symbol.
		*/
		function create(name, kind, range, uri, containerName) {
			const result = {
				name,
				kind,
				location: {
					uri,
					range
				}
			};
			if (containerName) result.containerName = containerName;
			return result;
		}
		SymbolInformation.create = create;
	})(SymbolInformation || (SymbolInformation = {}));
	(function(WorkspaceSymbol) {
		/**
		* Create a new workspace symbol.
		*
		* @param name The name of the symbol.
		* @param kind The kind of the symbol.
		* @param uri The resource of the location of the symbol.
		* @param range An options range of the location.
		* @returns A WorkspaceSymbol.
		*/
		function create(name, kind, uri, range) {
			return range !== void 0 ? {
				name,
				kind,
				location: {
					uri,
					range
				}
			} : {
				name,
				kind,
				location: { uri }
			};
		}
		WorkspaceSymbol.create = create;
	})(WorkspaceSymbol || (WorkspaceSymbol = {}));
	(function(DocumentSymbol) {
		/**
		* Creates a new symbol information literal.
		*
		* @param name The name of the symbol.
		* @param detail The detail of the symbol.
		* @param kind The kind of the symbol.
		* @param range The range of the symbol.
		* @param selectionRange The selectionRange of the symbol.
		* @param children Children of the symbol.
		*/
		function create(name, detail, kind, range, selectionRange, children) {
			const result = {
				name,
				detail,
				kind,
				range,
				selectionRange
			};
			if (children !== void 0) result.children = children;
			return result;
		}
		DocumentSymbol.create = create;
		/**
		* Checks whether the given literal conforms to the {@link DocumentSymbol} interface.
		*/
		function is(value) {
			const candidate = value;
			return candidate && Is.string(candidate.name) && Is.number(candidate.kind) && Range.is(candidate.range) && Range.is(candidate.selectionRange) && (candidate.detail === void 0 || Is.string(candidate.detail)) && (candidate.deprecated === void 0 || Is.boolean(candidate.deprecated)) && (candidate.children === void 0 || Array.isArray(candidate.children)) && (candidate.tags === void 0 || Array.isArray(candidate.tags));
		}
		DocumentSymbol.is = is;
	})(DocumentSymbol || (DocumentSymbol = {}));
	(function(CodeActionKind) {
		/**
		* Empty kind.
		*/
		CodeActionKind.Empty = "";
		/**
		* Base kind for quickfix actions: 'quickfix'
		*/
		CodeActionKind.QuickFix = "quickfix";
		/**
		* Base kind for refactoring actions: 'refactor'
		*/
		CodeActionKind.Refactor = "refactor";
		/**
		* Base kind for refactoring extraction actions: 'refactor.extract'
		*
		* Example extract actions:
		*
		* - Extract method
		* - Extract function
		* - Extract variable
		* - Extract interface from class
		* - ...
		*/
		CodeActionKind.RefactorExtract = "refactor.extract";
		/**
		* Base kind for refactoring inline actions: 'refactor.inline'
		*
		* Example inline actions:
		*
		* - Inline function
		* - Inline variable
		* - Inline constant
		* - ...
		*/
		CodeActionKind.RefactorInline = "refactor.inline";
		/**
		* Base kind for refactoring move actions: `refactor.move`
		*
		* Example move actions:
		*
		* - Move a function to a new file
		* - Move a property between classes
		* - Move method to base class
		* - ...
		*
		* @since 3.18.0
		*/
		CodeActionKind.RefactorMove = "refactor.move";
		/**
		* Base kind for refactoring rewrite actions: 'refactor.rewrite'
		*
		* Example rewrite actions:
		*
		* - Convert JavaScript function to class
		* - Add or remove parameter
		* - Encapsulate field
		* - Make method static
		* - Move method to base class
		* - ...
		*/
		CodeActionKind.RefactorRewrite = "refactor.rewrite";
		/**
		* Base kind for source actions: `source`
		*
		* Source code actions apply to the entire file.
		*/
		CodeActionKind.Source = "source";
		/**
		* Base kind for an organize imports source action: `source.organizeImports`
		*/
		CodeActionKind.SourceOrganizeImports = "source.organizeImports";
		/**
		* Base kind for auto-fix source actions: `source.fixAll`.
		*
		* Fix all actions automatically fix errors that have a clear fix that do not require user input.
		* They should not suppress errors or perform unsafe fixes such as generating new types or classes.
		*
		* @since 3.15.0
		*/
		CodeActionKind.SourceFixAll = "source.fixAll";
		/**
		* Base kind for all code actions applying to the entire notebook's scope. CodeActionKinds using
		* this should always begin with `notebook.`
		*
		* @since 3.18.0
		*/
		CodeActionKind.Notebook = "notebook";
	})(CodeActionKind || (CodeActionKind = {}));
	(function(CodeActionTriggerKind) {
		/**
		* Code actions were explicitly requested by the user or by an extension.
		*/
		CodeActionTriggerKind.Invoked = 1;
		/**
		* Code actions were requested automatically.
		*
		* This typically happens when current selection in a file changes, but can
		* also be triggered when file content changes.
		*/
		CodeActionTriggerKind.Automatic = 2;
	})(CodeActionTriggerKind || (CodeActionTriggerKind = {}));
	(function(CodeActionContext) {
		/**
		* Creates a new CodeActionContext literal.
		*/
		function create(diagnostics, only, triggerKind) {
			const result = { diagnostics };
			if (only !== void 0 && only !== null) result.only = only;
			if (triggerKind !== void 0 && triggerKind !== null) result.triggerKind = triggerKind;
			return result;
		}
		CodeActionContext.create = create;
		/**
		* Checks whether the given literal conforms to the {@link CodeActionContext} interface.
		*/
		function is(value) {
			const candidate = value;
			return Is.defined(candidate) && Is.typedArray(candidate.diagnostics, Diagnostic.is) && (candidate.only === void 0 || Is.typedArray(candidate.only, Is.string)) && (candidate.triggerKind === void 0 || candidate.triggerKind === CodeActionTriggerKind.Invoked || candidate.triggerKind === CodeActionTriggerKind.Automatic);
		}
		CodeActionContext.is = is;
	})(CodeActionContext || (CodeActionContext = {}));
	(function(CodeActionTag) {
		/**
		* Marks the code action as LLM-generated.
		*/
		CodeActionTag.LLMGenerated = 1;
		/**
		* Checks whether the given literal conforms to the {@link CodeActionTag} interface.
		*/
		function is(value) {
			return Is.defined(value) && value === CodeActionTag.LLMGenerated;
		}
		CodeActionTag.is = is;
	})(CodeActionTag || (CodeActionTag = {}));
	(function(CodeAction) {
		function create(title, kindOrCommandOrEdit, kind) {
			const result = { title };
			let checkKind = true;
			if (typeof kindOrCommandOrEdit === "string") {
				checkKind = false;
				result.kind = kindOrCommandOrEdit;
			} else if (Command.is(kindOrCommandOrEdit)) result.command = kindOrCommandOrEdit;
			else result.edit = kindOrCommandOrEdit;
			if (checkKind && kind !== void 0) result.kind = kind;
			return result;
		}
		CodeAction.create = create;
		function is(value) {
			const candidate = value;
			return candidate && Is.string(candidate.title) && (candidate.diagnostics === void 0 || Is.typedArray(candidate.diagnostics, Diagnostic.is)) && (candidate.kind === void 0 || Is.string(candidate.kind)) && (candidate.edit !== void 0 || candidate.command !== void 0) && (candidate.command === void 0 || Command.is(candidate.command)) && (candidate.isPreferred === void 0 || Is.boolean(candidate.isPreferred)) && (candidate.edit === void 0 || WorkspaceEdit.is(candidate.edit)) && (candidate.tags === void 0 || Is.typedArray(candidate.tags, CodeActionTag.is));
		}
		CodeAction.is = is;
	})(CodeAction || (CodeAction = {}));
	(function(CodeLens) {
		/**
		* Creates a new CodeLens literal.
		*/
		function create(range, data) {
			const result = { range };
			if (Is.defined(data)) result.data = data;
			return result;
		}
		CodeLens.create = create;
		/**
		* Checks whether the given literal conforms to the {@link CodeLens} interface.
		*/
		function is(value) {
			const candidate = value;
			return Is.defined(candidate) && Range.is(candidate.range) && (Is.undefined(candidate.command) || Command.is(candidate.command));
		}
		CodeLens.is = is;
	})(CodeLens || (CodeLens = {}));
	(function(FormattingOptions) {
		/**
		* Creates a new FormattingOptions literal.
		*/
		function create(tabSize, insertSpaces) {
			return {
				tabSize,
				insertSpaces
			};
		}
		FormattingOptions.create = create;
		/**
		* Checks whether the given literal conforms to the {@link FormattingOptions} interface.
		*/
		function is(value) {
			const candidate = value;
			return Is.defined(candidate) && Is.uinteger(candidate.tabSize) && Is.boolean(candidate.insertSpaces);
		}
		FormattingOptions.is = is;
	})(FormattingOptions || (FormattingOptions = {}));
	(function(DocumentLink) {
		/**
		* Creates a new DocumentLink literal.
		*/
		function create(range, target, data) {
			return {
				range,
				target,
				data
			};
		}
		DocumentLink.create = create;
		/**
		* Checks whether the given literal conforms to the {@link DocumentLink} interface.
		*/
		function is(value) {
			const candidate = value;
			return Is.defined(candidate) && Range.is(candidate.range) && (Is.undefined(candidate.target) || Is.string(candidate.target));
		}
		DocumentLink.is = is;
	})(DocumentLink || (DocumentLink = {}));
	(function(SelectionRange) {
		/**
		* Creates a new SelectionRange
		* @param range the range.
		* @param parent an optional parent.
		*/
		function create(range, parent) {
			return {
				range,
				parent
			};
		}
		SelectionRange.create = create;
		function is(value) {
			const candidate = value;
			return Is.objectLiteral(candidate) && Range.is(candidate.range) && (candidate.parent === void 0 || SelectionRange.is(candidate.parent));
		}
		SelectionRange.is = is;
	})(SelectionRange || (SelectionRange = {}));
	(function(SemanticTokenTypes) {
		SemanticTokenTypes["namespace"] = "namespace";
		/**
		* Represents a generic type. Acts as a fallback for types which can't be mapped to
		* a specific type like class or enum.
		*/
		SemanticTokenTypes["type"] = "type";
		SemanticTokenTypes["class"] = "class";
		SemanticTokenTypes["enum"] = "enum";
		SemanticTokenTypes["interface"] = "interface";
		SemanticTokenTypes["struct"] = "struct";
		SemanticTokenTypes["typeParameter"] = "typeParameter";
		SemanticTokenTypes["parameter"] = "parameter";
		SemanticTokenTypes["variable"] = "variable";
		SemanticTokenTypes["property"] = "property";
		SemanticTokenTypes["enumMember"] = "enumMember";
		SemanticTokenTypes["event"] = "event";
		SemanticTokenTypes["function"] = "function";
		SemanticTokenTypes["method"] = "method";
		SemanticTokenTypes["macro"] = "macro";
		SemanticTokenTypes["keyword"] = "keyword";
		SemanticTokenTypes["modifier"] = "modifier";
		SemanticTokenTypes["comment"] = "comment";
		SemanticTokenTypes["string"] = "string";
		SemanticTokenTypes["number"] = "number";
		SemanticTokenTypes["regexp"] = "regexp";
		SemanticTokenTypes["operator"] = "operator";
		/**
		* @since 3.17.0
		*/
		SemanticTokenTypes["decorator"] = "decorator";
		/**
		* @since 3.18.0
		*/
		SemanticTokenTypes["label"] = "label";
	})(SemanticTokenTypes || (SemanticTokenTypes = {}));
	(function(SemanticTokenModifiers) {
		SemanticTokenModifiers["declaration"] = "declaration";
		SemanticTokenModifiers["definition"] = "definition";
		SemanticTokenModifiers["readonly"] = "readonly";
		SemanticTokenModifiers["static"] = "static";
		SemanticTokenModifiers["deprecated"] = "deprecated";
		SemanticTokenModifiers["abstract"] = "abstract";
		SemanticTokenModifiers["async"] = "async";
		SemanticTokenModifiers["modification"] = "modification";
		SemanticTokenModifiers["documentation"] = "documentation";
		SemanticTokenModifiers["defaultLibrary"] = "defaultLibrary";
	})(SemanticTokenModifiers || (SemanticTokenModifiers = {}));
	(function(SemanticTokens) {
		function is(value) {
			const candidate = value;
			return Is.objectLiteral(candidate) && (candidate.resultId === void 0 || typeof candidate.resultId === "string") && Array.isArray(candidate.data) && (candidate.data.length === 0 || typeof candidate.data[0] === "number");
		}
		SemanticTokens.is = is;
	})(SemanticTokens || (SemanticTokens = {}));
	(function(InlineValueText) {
		/**
		* Creates a new InlineValueText literal.
		*/
		function create(range, text) {
			return {
				range,
				text
			};
		}
		InlineValueText.create = create;
		function is(value) {
			const candidate = value;
			return candidate !== void 0 && candidate !== null && Range.is(candidate.range) && Is.string(candidate.text);
		}
		InlineValueText.is = is;
	})(InlineValueText || (InlineValueText = {}));
	(function(InlineValueVariableLookup) {
		/**
		* Creates a new InlineValueText literal.
		*/
		function create(range, variableName, caseSensitiveLookup) {
			return {
				range,
				variableName,
				caseSensitiveLookup
			};
		}
		InlineValueVariableLookup.create = create;
		function is(value) {
			const candidate = value;
			return candidate !== void 0 && candidate !== null && Range.is(candidate.range) && Is.boolean(candidate.caseSensitiveLookup) && (Is.string(candidate.variableName) || candidate.variableName === void 0);
		}
		InlineValueVariableLookup.is = is;
	})(InlineValueVariableLookup || (InlineValueVariableLookup = {}));
	(function(InlineValueEvaluatableExpression) {
		/**
		* Creates a new InlineValueEvaluatableExpression literal.
		*/
		function create(range, expression) {
			return {
				range,
				expression
			};
		}
		InlineValueEvaluatableExpression.create = create;
		function is(value) {
			const candidate = value;
			return candidate !== void 0 && candidate !== null && Range.is(candidate.range) && (Is.string(candidate.expression) || candidate.expression === void 0);
		}
		InlineValueEvaluatableExpression.is = is;
	})(InlineValueEvaluatableExpression || (InlineValueEvaluatableExpression = {}));
	(function(InlineValueContext) {
		/**
		* Creates a new InlineValueContext literal.
		*/
		function create(frameId, stoppedLocation) {
			return {
				frameId,
				stoppedLocation
			};
		}
		InlineValueContext.create = create;
		/**
		* Checks whether the given literal conforms to the {@link InlineValueContext} interface.
		*/
		function is(value) {
			const candidate = value;
			return Is.defined(candidate) && Range.is(value.stoppedLocation);
		}
		InlineValueContext.is = is;
	})(InlineValueContext || (InlineValueContext = {}));
	(function(InlayHintKind) {
		/**
		* An inlay hint that for a type annotation.
		*/
		InlayHintKind.Type = 1;
		/**
		* An inlay hint that is for a parameter.
		*/
		InlayHintKind.Parameter = 2;
		function is(value) {
			return value === 1 || value === 2;
		}
		InlayHintKind.is = is;
	})(InlayHintKind || (InlayHintKind = {}));
	(function(InlayHintLabelPart) {
		function create(value) {
			return { value };
		}
		InlayHintLabelPart.create = create;
		function is(value) {
			const candidate = value;
			return Is.objectLiteral(candidate) && (candidate.tooltip === void 0 || Is.string(candidate.tooltip) || MarkupContent.is(candidate.tooltip)) && (candidate.location === void 0 || Location.is(candidate.location)) && (candidate.command === void 0 || Command.is(candidate.command));
		}
		InlayHintLabelPart.is = is;
	})(InlayHintLabelPart || (InlayHintLabelPart = {}));
	(function(InlayHint) {
		function create(position, label, kind) {
			const result = {
				position,
				label
			};
			if (kind !== void 0) result.kind = kind;
			return result;
		}
		InlayHint.create = create;
		function is(value) {
			const candidate = value;
			return Is.objectLiteral(candidate) && Position.is(candidate.position) && (Is.string(candidate.label) || Is.typedArray(candidate.label, InlayHintLabelPart.is)) && (candidate.kind === void 0 || InlayHintKind.is(candidate.kind)) && candidate.textEdits === void 0 || Is.typedArray(candidate.textEdits, TextEdit.is) && (candidate.tooltip === void 0 || Is.string(candidate.tooltip) || MarkupContent.is(candidate.tooltip)) && (candidate.paddingLeft === void 0 || Is.boolean(candidate.paddingLeft)) && (candidate.paddingRight === void 0 || Is.boolean(candidate.paddingRight));
		}
		InlayHint.is = is;
	})(InlayHint || (InlayHint = {}));
	(function(StringValue) {
		function createSnippet(value) {
			return {
				kind: "snippet",
				value
			};
		}
		StringValue.createSnippet = createSnippet;
		function isSnippet(value) {
			const candidate = value;
			return Is.objectLiteral(candidate) && candidate.kind === "snippet" && Is.string(candidate.value);
		}
		StringValue.isSnippet = isSnippet;
	})(StringValue || (StringValue = {}));
	(function(InlineCompletionItem) {
		function create(insertText, filterText, range, command) {
			return {
				insertText,
				filterText,
				range,
				command
			};
		}
		InlineCompletionItem.create = create;
	})(InlineCompletionItem || (InlineCompletionItem = {}));
	(function(InlineCompletionList) {
		function create(items) {
			return { items };
		}
		InlineCompletionList.create = create;
	})(InlineCompletionList || (InlineCompletionList = {}));
	(function(InlineCompletionTriggerKind) {
		/**
		* Completion was triggered explicitly by a user gesture.
		*/
		InlineCompletionTriggerKind.Invoked = 1;
		/**
		* Completion was triggered automatically while editing.
		*/
		InlineCompletionTriggerKind.Automatic = 2;
	})(InlineCompletionTriggerKind || (InlineCompletionTriggerKind = {}));
	(function(SelectedCompletionInfo) {
		function create(range, text) {
			return {
				range,
				text
			};
		}
		SelectedCompletionInfo.create = create;
	})(SelectedCompletionInfo || (SelectedCompletionInfo = {}));
	(function(InlineCompletionContext) {
		function create(triggerKind, selectedCompletionInfo) {
			return {
				triggerKind,
				selectedCompletionInfo
			};
		}
		InlineCompletionContext.create = create;
	})(InlineCompletionContext || (InlineCompletionContext = {}));
	(function(WorkspaceFolder) {
		function is(value) {
			const candidate = value;
			return Is.objectLiteral(candidate) && URI.is(candidate.uri) && Is.string(candidate.name);
		}
		WorkspaceFolder.is = is;
	})(WorkspaceFolder || (WorkspaceFolder = {}));
	EOL = [
		"\n",
		"\r\n",
		"\r"
	];
	(function(TextDocument) {
		/**
		* Creates a new ITextDocument literal from the given uri and content.
		* @param uri The document's uri.
		* @param languageId The document's language Id.
		* @param version The document's version.
		* @param content The document's content.
		*/
		function create(uri, languageId, version, content) {
			return new FullTextDocument$1(uri, languageId, version, content);
		}
		TextDocument.create = create;
		/**
		* Checks whether the given literal conforms to the {@link ITextDocument} interface.
		*/
		function is(value) {
			const candidate = value;
			return Is.defined(candidate) && Is.string(candidate.uri) && (Is.undefined(candidate.languageId) || Is.string(candidate.languageId)) && Is.uinteger(candidate.lineCount) && Is.func(candidate.getText) && Is.func(candidate.positionAt) && Is.func(candidate.offsetAt) ? true : false;
		}
		TextDocument.is = is;
		function applyEdits(document, edits) {
			let text = document.getText();
			const sortedEdits = mergeSort(edits, (a, b) => {
				const diff = a.range.start.line - b.range.start.line;
				if (diff === 0) return a.range.start.character - b.range.start.character;
				return diff;
			});
			let lastModifiedOffset = text.length;
			for (let i = sortedEdits.length - 1; i >= 0; i--) {
				const e = sortedEdits[i];
				const startOffset = document.offsetAt(e.range.start);
				const endOffset = document.offsetAt(e.range.end);
				if (endOffset <= lastModifiedOffset) text = text.substring(0, startOffset) + e.newText + text.substring(endOffset, text.length);
				else throw new Error("Overlapping edit");
				lastModifiedOffset = startOffset;
			}
			return text;
		}
		TextDocument.applyEdits = applyEdits;
		function mergeSort(data, compare) {
			if (data.length <= 1) return data;
			const p = data.length / 2 | 0;
			const left = data.slice(0, p);
			const right = data.slice(p);
			mergeSort(left, compare);
			mergeSort(right, compare);
			let leftIdx = 0;
			let rightIdx = 0;
			let i = 0;
			while (leftIdx < left.length && rightIdx < right.length) if (compare(left[leftIdx], right[rightIdx]) <= 0) data[i++] = left[leftIdx++];
			else data[i++] = right[rightIdx++];
			while (leftIdx < left.length) data[i++] = left[leftIdx++];
			while (rightIdx < right.length) data[i++] = right[rightIdx++];
			return data;
		}
	})(TextDocument$1 || (TextDocument$1 = {}));
	FullTextDocument$1 = class {
		constructor(uri, languageId, version, content) {
			this._uri = uri;
			this._languageId = languageId;
			this._version = version;
			this._content = content;
			this._lineOffsets = void 0;
		}
		get uri() {
			return this._uri;
		}
		get languageId() {
			return this._languageId;
		}
		get version() {
			return this._version;
		}
		getText(range) {
			if (range) {
				const start = this.offsetAt(range.start);
				const end = this.offsetAt(range.end);
				return this._content.substring(start, end);
			}
			return this._content;
		}
		update(event, version) {
			this._content = event.text;
			this._version = version;
			this._lineOffsets = void 0;
		}
		getLineOffsets() {
			if (this._lineOffsets === void 0) {
				const lineOffsets = [];
				const text = this._content;
				let isLineStart = true;
				for (let i = 0; i < text.length; i++) {
					if (isLineStart) {
						lineOffsets.push(i);
						isLineStart = false;
					}
					const ch = text.charAt(i);
					isLineStart = ch === "\r" || ch === "\n";
					if (ch === "\r" && i + 1 < text.length && text.charAt(i + 1) === "\n") i++;
				}
				if (isLineStart && text.length > 0) lineOffsets.push(text.length);
				this._lineOffsets = lineOffsets;
			}
			return this._lineOffsets;
		}
		positionAt(offset) {
			offset = Math.max(Math.min(offset, this._content.length), 0);
			const lineOffsets = this.getLineOffsets();
			let low = 0, high = lineOffsets.length;
			if (high === 0) return Position.create(0, offset);
			while (low < high) {
				const mid = Math.floor((low + high) / 2);
				if (lineOffsets[mid] > offset) high = mid;
				else low = mid + 1;
			}
			const line = low - 1;
			return Position.create(line, offset - lineOffsets[line]);
		}
		offsetAt(position) {
			const lineOffsets = this.getLineOffsets();
			if (position.line >= lineOffsets.length) return this._content.length;
			else if (position.line < 0) return 0;
			const lineOffset = lineOffsets[position.line];
			const nextLineOffset = position.line + 1 < lineOffsets.length ? lineOffsets[position.line + 1] : this._content.length;
			return Math.max(Math.min(lineOffset + position.character, nextLineOffset), lineOffset);
		}
		get lineCount() {
			return this.getLineOffsets().length;
		}
	};
	(function(Is) {
		const toString = Object.prototype.toString;
		function defined(value) {
			return typeof value !== "undefined";
		}
		Is.defined = defined;
		function undefined(value) {
			return typeof value === "undefined";
		}
		Is.undefined = undefined;
		function boolean(value) {
			return value === true || value === false;
		}
		Is.boolean = boolean;
		function string(value) {
			return toString.call(value) === "[object String]";
		}
		Is.string = string;
		function number(value) {
			return toString.call(value) === "[object Number]";
		}
		Is.number = number;
		function numberRange(value, min, max) {
			return toString.call(value) === "[object Number]" && min <= value && value <= max;
		}
		Is.numberRange = numberRange;
		function integer(value) {
			return toString.call(value) === "[object Number]" && -2147483648 <= value && value <= 2147483647;
		}
		Is.integer = integer;
		function uinteger(value) {
			return toString.call(value) === "[object Number]" && 0 <= value && value <= 2147483647;
		}
		Is.uinteger = uinteger;
		function func(value) {
			return toString.call(value) === "[object Function]";
		}
		Is.func = func;
		function objectLiteral(value) {
			return value !== null && typeof value === "object";
		}
		Is.objectLiteral = objectLiteral;
		function typedArray(value, check) {
			return Array.isArray(value) && value.every(check);
		}
		Is.typedArray = typedArray;
	})(Is || (Is = {}));
}));
// node_modules/vscode-languageserver-protocol/lib/common/messages.js
var require_messages = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.CM = exports.ProtocolNotificationType = exports.ProtocolNotificationType0 = exports.ProtocolRequestType = exports.ProtocolRequestType0 = exports.RegistrationType = exports.MessageDirection = void 0;
	var vscode_jsonrpc_1 = require_api$2();
	var MessageDirection;
	(function(MessageDirection) {
		MessageDirection["clientToServer"] = "clientToServer";
		MessageDirection["serverToClient"] = "serverToClient";
		MessageDirection["both"] = "both";
	})(MessageDirection || (exports.MessageDirection = MessageDirection = {}));
	var RegistrationType = class {
		/**
		* Clients must not use this property. It is here to ensure correct typing.
		*/
		____;
		method;
		constructor(method) {
			this.method = method;
		}
	};
	exports.RegistrationType = RegistrationType;
	var ProtocolRequestType0 = class extends vscode_jsonrpc_1.RequestType0 {
		/**
		* Clients must not use these properties. They are here to ensure correct typing.
		* in TypeScript
		*/
		__;
		___;
		____;
		_pr;
		constructor(method) {
			super(method);
		}
	};
	exports.ProtocolRequestType0 = ProtocolRequestType0;
	var ProtocolRequestType = class extends vscode_jsonrpc_1.RequestType {
		/**
		* Clients must not use this property. It is here to ensure correct typing.
		*/
		__;
		___;
		____;
		_pr;
		constructor(method) {
			super(method, vscode_jsonrpc_1.ParameterStructures.byName);
		}
	};
	exports.ProtocolRequestType = ProtocolRequestType;
	var ProtocolNotificationType0 = class extends vscode_jsonrpc_1.NotificationType0 {
		/**
		* Clients must not use this property. It is here to ensure correct typing.
		*/
		___;
		____;
		constructor(method) {
			super(method);
		}
	};
	exports.ProtocolNotificationType0 = ProtocolNotificationType0;
	var ProtocolNotificationType = class extends vscode_jsonrpc_1.NotificationType {
		/**
		* Clients must not use this property. It is here to ensure correct typing.
		*/
		___;
		____;
		constructor(method) {
			super(method, vscode_jsonrpc_1.ParameterStructures.byName);
		}
	};
	exports.ProtocolNotificationType = ProtocolNotificationType;
	var CM;
	(function(CM) {
		function create(client, server) {
			return {
				client,
				server
			};
		}
		CM.create = create;
	})(CM || (exports.CM = CM = {}));
}));
// node_modules/vscode-languageserver-protocol/lib/common/utils/is.js
var require_is = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.boolean = boolean;
	exports.string = string;
	exports.number = number;
	exports.error = error;
	exports.func = func;
	exports.array = array;
	exports.stringArray = stringArray;
	exports.typedArray = typedArray;
	exports.objectLiteral = objectLiteral;
	function boolean(value) {
		return value === true || value === false;
	}
	function string(value) {
		return typeof value === "string" || value instanceof String;
	}
	function number(value) {
		return typeof value === "number" || value instanceof Number;
	}
	function error(value) {
		return value instanceof Error;
	}
	function func(value) {
		return typeof value === "function";
	}
	function array(value) {
		return Array.isArray(value);
	}
	function stringArray(value) {
		return array(value) && value.every((elem) => string(elem));
	}
	function typedArray(value, check) {
		return Array.isArray(value) && value.every(check);
	}
	function objectLiteral(value) {
		return value !== null && typeof value === "object";
	}
}));
// node_modules/vscode-languageserver-protocol/lib/common/protocol.implementation.js
var require_protocol_implementation = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.ImplementationRequest = void 0;
	var messages_1 = require_messages();
	/**
	* A request to resolve the implementation locations of a symbol at a given text
	* document position. The request's parameter is of type {@link TextDocumentPositionParams}
	* the response is of type {@link Definition} or a Thenable that resolves to such.
	*/
	var ImplementationRequest;
	(function(ImplementationRequest) {
		ImplementationRequest.method = "textDocument/implementation";
		ImplementationRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		ImplementationRequest.type = new messages_1.ProtocolRequestType(ImplementationRequest.method);
		ImplementationRequest.capabilities = messages_1.CM.create("textDocument.implementation", "implementationProvider");
	})(ImplementationRequest || (exports.ImplementationRequest = ImplementationRequest = {}));
}));
// node_modules/vscode-languageserver-protocol/lib/common/protocol.typeDefinition.js
var require_protocol_typeDefinition = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.TypeDefinitionRequest = void 0;
	var messages_1 = require_messages();
	/**
	* A request to resolve the type definition locations of a symbol at a given text
	* document position. The request's parameter is of type {@link TextDocumentPositionParams}
	* the response is of type {@link Definition} or a Thenable that resolves to such.
	*/
	var TypeDefinitionRequest;
	(function(TypeDefinitionRequest) {
		TypeDefinitionRequest.method = "textDocument/typeDefinition";
		TypeDefinitionRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		TypeDefinitionRequest.type = new messages_1.ProtocolRequestType(TypeDefinitionRequest.method);
		TypeDefinitionRequest.capabilities = messages_1.CM.create("textDocument.typeDefinition", "typeDefinitionProvider");
	})(TypeDefinitionRequest || (exports.TypeDefinitionRequest = TypeDefinitionRequest = {}));
}));
// node_modules/vscode-languageserver-protocol/lib/common/protocol.workspaceFolder.js
var require_protocol_workspaceFolder = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.DidChangeWorkspaceFoldersNotification = exports.WorkspaceFoldersRequest = void 0;
	var messages_1 = require_messages();
	/**
	* The `workspace/workspaceFolders` is sent from the server to the client to fetch the open workspace folders.
	*/
	var WorkspaceFoldersRequest;
	(function(WorkspaceFoldersRequest) {
		WorkspaceFoldersRequest.method = "workspace/workspaceFolders";
		WorkspaceFoldersRequest.messageDirection = messages_1.MessageDirection.serverToClient;
		WorkspaceFoldersRequest.type = new messages_1.ProtocolRequestType0(WorkspaceFoldersRequest.method);
		WorkspaceFoldersRequest.capabilities = messages_1.CM.create("workspace.workspaceFolders", "workspace.workspaceFolders");
	})(WorkspaceFoldersRequest || (exports.WorkspaceFoldersRequest = WorkspaceFoldersRequest = {}));
	/**
	* The `workspace/didChangeWorkspaceFolders` notification is sent from the client to the server when the workspace
	* folder configuration changes.
	*/
	var DidChangeWorkspaceFoldersNotification;
	(function(DidChangeWorkspaceFoldersNotification) {
		DidChangeWorkspaceFoldersNotification.method = "workspace/didChangeWorkspaceFolders";
		DidChangeWorkspaceFoldersNotification.messageDirection = messages_1.MessageDirection.clientToServer;
		DidChangeWorkspaceFoldersNotification.type = new messages_1.ProtocolNotificationType(DidChangeWorkspaceFoldersNotification.method);
		DidChangeWorkspaceFoldersNotification.capabilities = messages_1.CM.create(void 0, "workspace.workspaceFolders.changeNotifications");
	})(DidChangeWorkspaceFoldersNotification || (exports.DidChangeWorkspaceFoldersNotification = DidChangeWorkspaceFoldersNotification = {}));
}));
// node_modules/vscode-languageserver-protocol/lib/common/protocol.configuration.js
var require_protocol_configuration = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.ConfigurationRequest = void 0;
	var messages_1 = require_messages();
	/**
	* The 'workspace/configuration' request is sent from the server to the client to fetch a certain
	* configuration setting.
	*
	* This pull model replaces the old push model were the client signaled configuration change via an
	* event. If the server still needs to react to configuration changes (since the server caches the
	* result of `workspace/configuration` requests) the server should register for an empty configuration
	* change event and empty the cache if such an event is received.
	*/
	var ConfigurationRequest;
	(function(ConfigurationRequest) {
		ConfigurationRequest.method = "workspace/configuration";
		ConfigurationRequest.messageDirection = messages_1.MessageDirection.serverToClient;
		ConfigurationRequest.type = new messages_1.ProtocolRequestType(ConfigurationRequest.method);
		ConfigurationRequest.capabilities = messages_1.CM.create("workspace.configuration", void 0);
	})(ConfigurationRequest || (exports.ConfigurationRequest = ConfigurationRequest = {}));
}));
// node_modules/vscode-languageserver-protocol/lib/common/protocol.colorProvider.js
var require_protocol_colorProvider = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.ColorPresentationRequest = exports.DocumentColorRequest = void 0;
	var messages_1 = require_messages();
	/**
	* A request to list all color symbols found in a given text document. The request's
	* parameter is of type {@link DocumentColorParams} the
	* response is of type {@link ColorInformation ColorInformation[]} or a Thenable
	* that resolves to such.
	*/
	var DocumentColorRequest;
	(function(DocumentColorRequest) {
		DocumentColorRequest.method = "textDocument/documentColor";
		DocumentColorRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		DocumentColorRequest.type = new messages_1.ProtocolRequestType(DocumentColorRequest.method);
		DocumentColorRequest.capabilities = messages_1.CM.create("textDocument.colorProvider", "colorProvider");
	})(DocumentColorRequest || (exports.DocumentColorRequest = DocumentColorRequest = {}));
	/**
	* A request to list all presentation for a color. The request's
	* parameter is of type {@link ColorPresentationParams} the
	* response is of type {@link ColorPresentation ColorPresentation[]} or a Thenable
	* that resolves to such.
	*/
	var ColorPresentationRequest;
	(function(ColorPresentationRequest) {
		ColorPresentationRequest.method = "textDocument/colorPresentation";
		ColorPresentationRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		ColorPresentationRequest.type = new messages_1.ProtocolRequestType(ColorPresentationRequest.method);
		ColorPresentationRequest.capabilities = messages_1.CM.create("textDocument.colorProvider", "colorProvider");
	})(ColorPresentationRequest || (exports.ColorPresentationRequest = ColorPresentationRequest = {}));
}));
// node_modules/vscode-languageserver-protocol/lib/common/protocol.foldingRange.js
var require_protocol_foldingRange = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.FoldingRangeRefreshRequest = exports.FoldingRangeRequest = void 0;
	var messages_1 = require_messages();
	/**
	* A request to provide folding ranges in a document. The request's
	* parameter is of type {@link FoldingRangeParams}, the
	* response is of type {@link FoldingRangeList} or a Thenable
	* that resolves to such.
	*/
	var FoldingRangeRequest;
	(function(FoldingRangeRequest) {
		FoldingRangeRequest.method = "textDocument/foldingRange";
		FoldingRangeRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		FoldingRangeRequest.type = new messages_1.ProtocolRequestType(FoldingRangeRequest.method);
		FoldingRangeRequest.capabilities = messages_1.CM.create("textDocument.foldingRange", "foldingRangeProvider");
	})(FoldingRangeRequest || (exports.FoldingRangeRequest = FoldingRangeRequest = {}));
	/**
	* A request to refresh the folding ranges in a document.
	*
	* @since 3.18.0
	*/
	var FoldingRangeRefreshRequest;
	(function(FoldingRangeRefreshRequest) {
		FoldingRangeRefreshRequest.method = `workspace/foldingRange/refresh`;
		FoldingRangeRefreshRequest.messageDirection = messages_1.MessageDirection.serverToClient;
		FoldingRangeRefreshRequest.type = new messages_1.ProtocolRequestType0(FoldingRangeRefreshRequest.method);
		FoldingRangeRefreshRequest.capabilities = messages_1.CM.create("workspace.foldingRange.refreshSupport", void 0);
	})(FoldingRangeRefreshRequest || (exports.FoldingRangeRefreshRequest = FoldingRangeRefreshRequest = {}));
}));
// node_modules/vscode-languageserver-protocol/lib/common/protocol.declaration.js
var require_protocol_declaration = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.DeclarationRequest = void 0;
	var messages_1 = require_messages();
	/**
	* A request to resolve the type definition locations of a symbol at a given text
	* document position. The request's parameter is of type {@link TextDocumentPositionParams}
	* the response is of type {@link Declaration} or a typed array of {@link DeclarationLink}
	* or a Thenable that resolves to such.
	*/
	var DeclarationRequest;
	(function(DeclarationRequest) {
		DeclarationRequest.method = "textDocument/declaration";
		DeclarationRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		DeclarationRequest.type = new messages_1.ProtocolRequestType(DeclarationRequest.method);
		DeclarationRequest.capabilities = messages_1.CM.create("textDocument.declaration", "declarationProvider");
	})(DeclarationRequest || (exports.DeclarationRequest = DeclarationRequest = {}));
}));
// node_modules/vscode-languageserver-protocol/lib/common/protocol.selectionRange.js
var require_protocol_selectionRange = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.SelectionRangeRequest = void 0;
	var messages_1 = require_messages();
	/**
	* A request to provide selection ranges in a document. The request's
	* parameter is of type {@link SelectionRangeParams}, the
	* response is of type {@link SelectionRange SelectionRange[]} or a Thenable
	* that resolves to such.
	*/
	var SelectionRangeRequest;
	(function(SelectionRangeRequest) {
		SelectionRangeRequest.method = "textDocument/selectionRange";
		SelectionRangeRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		SelectionRangeRequest.type = new messages_1.ProtocolRequestType(SelectionRangeRequest.method);
		SelectionRangeRequest.capabilities = messages_1.CM.create("textDocument.selectionRange", "selectionRangeProvider");
	})(SelectionRangeRequest || (exports.SelectionRangeRequest = SelectionRangeRequest = {}));
}));
// node_modules/vscode-languageserver-protocol/lib/common/protocol.progress.js
var require_protocol_progress = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.WorkDoneProgressCancelNotification = exports.WorkDoneProgressCreateRequest = exports.WorkDoneProgress = void 0;
	var vscode_jsonrpc_1 = require_api$2();
	var messages_1 = require_messages();
	var WorkDoneProgress;
	(function(WorkDoneProgress) {
		WorkDoneProgress.type = new vscode_jsonrpc_1.ProgressType();
		function is(value) {
			return value === WorkDoneProgress.type;
		}
		WorkDoneProgress.is = is;
	})(WorkDoneProgress || (exports.WorkDoneProgress = WorkDoneProgress = {}));
	/**
	* The `window/workDoneProgress/create` request is sent from the server to the client to initiate progress
	* reporting from the server.
	*/
	var WorkDoneProgressCreateRequest;
	(function(WorkDoneProgressCreateRequest) {
		WorkDoneProgressCreateRequest.method = "window/workDoneProgress/create";
		WorkDoneProgressCreateRequest.messageDirection = messages_1.MessageDirection.serverToClient;
		WorkDoneProgressCreateRequest.type = new messages_1.ProtocolRequestType(WorkDoneProgressCreateRequest.method);
		WorkDoneProgressCreateRequest.capabilities = messages_1.CM.create("window.workDoneProgress", void 0);
	})(WorkDoneProgressCreateRequest || (exports.WorkDoneProgressCreateRequest = WorkDoneProgressCreateRequest = {}));
	/**
	* The `window/workDoneProgress/cancel` notification is sent from  the client to the server to cancel a progress
	* initiated on the server side.
	*/
	var WorkDoneProgressCancelNotification;
	(function(WorkDoneProgressCancelNotification) {
		WorkDoneProgressCancelNotification.method = "window/workDoneProgress/cancel";
		WorkDoneProgressCancelNotification.messageDirection = messages_1.MessageDirection.clientToServer;
		WorkDoneProgressCancelNotification.type = new messages_1.ProtocolNotificationType(WorkDoneProgressCancelNotification.method);
	})(WorkDoneProgressCancelNotification || (exports.WorkDoneProgressCancelNotification = WorkDoneProgressCancelNotification = {}));
}));
// node_modules/vscode-languageserver-protocol/lib/common/protocol.callHierarchy.js
var require_protocol_callHierarchy = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.CallHierarchyOutgoingCallsRequest = exports.CallHierarchyIncomingCallsRequest = exports.CallHierarchyPrepareRequest = void 0;
	var messages_1 = require_messages();
	/**
	* A request to result a `CallHierarchyItem` in a document at a given position.
	* Can be used as an input to an incoming or outgoing call hierarchy.
	*
	* @since 3.16.0
	*/
	var CallHierarchyPrepareRequest;
	(function(CallHierarchyPrepareRequest) {
		CallHierarchyPrepareRequest.method = "textDocument/prepareCallHierarchy";
		CallHierarchyPrepareRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		CallHierarchyPrepareRequest.type = new messages_1.ProtocolRequestType(CallHierarchyPrepareRequest.method);
		CallHierarchyPrepareRequest.capabilities = messages_1.CM.create("textDocument.callHierarchy", "callHierarchyProvider");
	})(CallHierarchyPrepareRequest || (exports.CallHierarchyPrepareRequest = CallHierarchyPrepareRequest = {}));
	/**
	* A request to resolve the incoming calls for a given `CallHierarchyItem`.
	*
	* @since 3.16.0
	*/
	var CallHierarchyIncomingCallsRequest;
	(function(CallHierarchyIncomingCallsRequest) {
		CallHierarchyIncomingCallsRequest.method = "callHierarchy/incomingCalls";
		CallHierarchyIncomingCallsRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		CallHierarchyIncomingCallsRequest.type = new messages_1.ProtocolRequestType(CallHierarchyIncomingCallsRequest.method);
		CallHierarchyIncomingCallsRequest.capabilities = messages_1.CM.create("textDocument.callHierarchy", "callHierarchyProvider");
	})(CallHierarchyIncomingCallsRequest || (exports.CallHierarchyIncomingCallsRequest = CallHierarchyIncomingCallsRequest = {}));
	/**
	* A request to resolve the outgoing calls for a given `CallHierarchyItem`.
	*
	* @since 3.16.0
	*/
	var CallHierarchyOutgoingCallsRequest;
	(function(CallHierarchyOutgoingCallsRequest) {
		CallHierarchyOutgoingCallsRequest.method = "callHierarchy/outgoingCalls";
		CallHierarchyOutgoingCallsRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		CallHierarchyOutgoingCallsRequest.type = new messages_1.ProtocolRequestType(CallHierarchyOutgoingCallsRequest.method);
		CallHierarchyOutgoingCallsRequest.capabilities = messages_1.CM.create("textDocument.callHierarchy", "callHierarchyProvider");
	})(CallHierarchyOutgoingCallsRequest || (exports.CallHierarchyOutgoingCallsRequest = CallHierarchyOutgoingCallsRequest = {}));
}));
// node_modules/vscode-languageserver-protocol/lib/common/protocol.semanticTokens.js
var require_protocol_semanticTokens = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.SemanticTokensRefreshRequest = exports.SemanticTokensRangeRequest = exports.SemanticTokensDeltaRequest = exports.SemanticTokensRequest = exports.SemanticTokensRegistrationType = exports.TokenFormat = void 0;
	var messages_1 = require_messages();
	var TokenFormat;
	(function(TokenFormat) {
		TokenFormat.Relative = "relative";
	})(TokenFormat || (exports.TokenFormat = TokenFormat = {}));
	var SemanticTokensRegistrationType;
	(function(SemanticTokensRegistrationType) {
		SemanticTokensRegistrationType.method = "textDocument/semanticTokens";
		SemanticTokensRegistrationType.type = new messages_1.RegistrationType(SemanticTokensRegistrationType.method);
	})(SemanticTokensRegistrationType || (exports.SemanticTokensRegistrationType = SemanticTokensRegistrationType = {}));
	/**
	* @since 3.16.0
	*/
	var SemanticTokensRequest;
	(function(SemanticTokensRequest) {
		SemanticTokensRequest.method = "textDocument/semanticTokens/full";
		SemanticTokensRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		SemanticTokensRequest.type = new messages_1.ProtocolRequestType(SemanticTokensRequest.method);
		SemanticTokensRequest.registrationMethod = SemanticTokensRegistrationType.method;
		SemanticTokensRequest.capabilities = messages_1.CM.create("textDocument.semanticTokens", "semanticTokensProvider");
	})(SemanticTokensRequest || (exports.SemanticTokensRequest = SemanticTokensRequest = {}));
	/**
	* @since 3.16.0
	*/
	var SemanticTokensDeltaRequest;
	(function(SemanticTokensDeltaRequest) {
		SemanticTokensDeltaRequest.method = "textDocument/semanticTokens/full/delta";
		SemanticTokensDeltaRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		SemanticTokensDeltaRequest.type = new messages_1.ProtocolRequestType(SemanticTokensDeltaRequest.method);
		SemanticTokensDeltaRequest.registrationMethod = SemanticTokensRegistrationType.method;
		SemanticTokensDeltaRequest.capabilities = messages_1.CM.create("textDocument.semanticTokens.requests.full.delta", "semanticTokensProvider.full.delta");
	})(SemanticTokensDeltaRequest || (exports.SemanticTokensDeltaRequest = SemanticTokensDeltaRequest = {}));
	/**
	* @since 3.16.0
	*/
	var SemanticTokensRangeRequest;
	(function(SemanticTokensRangeRequest) {
		SemanticTokensRangeRequest.method = "textDocument/semanticTokens/range";
		SemanticTokensRangeRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		SemanticTokensRangeRequest.type = new messages_1.ProtocolRequestType(SemanticTokensRangeRequest.method);
		SemanticTokensRangeRequest.registrationMethod = SemanticTokensRegistrationType.method;
		SemanticTokensRangeRequest.capabilities = messages_1.CM.create("textDocument.semanticTokens.requests.range", "semanticTokensProvider.range");
	})(SemanticTokensRangeRequest || (exports.SemanticTokensRangeRequest = SemanticTokensRangeRequest = {}));
	/**
	* @since 3.16.0
	*/
	var SemanticTokensRefreshRequest;
	(function(SemanticTokensRefreshRequest) {
		SemanticTokensRefreshRequest.method = `workspace/semanticTokens/refresh`;
		SemanticTokensRefreshRequest.messageDirection = messages_1.MessageDirection.serverToClient;
		SemanticTokensRefreshRequest.type = new messages_1.ProtocolRequestType0(SemanticTokensRefreshRequest.method);
		SemanticTokensRefreshRequest.capabilities = messages_1.CM.create("workspace.semanticTokens.refreshSupport", void 0);
	})(SemanticTokensRefreshRequest || (exports.SemanticTokensRefreshRequest = SemanticTokensRefreshRequest = {}));
}));
// node_modules/vscode-languageserver-protocol/lib/common/protocol.showDocument.js
var require_protocol_showDocument = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.ShowDocumentRequest = void 0;
	var messages_1 = require_messages();
	/**
	* A request to show a document. This request might open an
	* external program depending on the value of the URI to open.
	* For example a request to open `https://code.visualstudio.com/`
	* will very likely open the URI in a WEB browser.
	*
	* @since 3.16.0
	*/
	var ShowDocumentRequest;
	(function(ShowDocumentRequest) {
		ShowDocumentRequest.method = "window/showDocument";
		ShowDocumentRequest.messageDirection = messages_1.MessageDirection.serverToClient;
		ShowDocumentRequest.type = new messages_1.ProtocolRequestType(ShowDocumentRequest.method);
		ShowDocumentRequest.capabilities = messages_1.CM.create("window.showDocument.support", void 0);
	})(ShowDocumentRequest || (exports.ShowDocumentRequest = ShowDocumentRequest = {}));
}));
// node_modules/vscode-languageserver-protocol/lib/common/protocol.linkedEditingRange.js
var require_protocol_linkedEditingRange = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.LinkedEditingRangeRequest = void 0;
	var messages_1 = require_messages();
	/**
	* A request to provide ranges that can be edited together.
	*
	* @since 3.16.0
	*/
	var LinkedEditingRangeRequest;
	(function(LinkedEditingRangeRequest) {
		LinkedEditingRangeRequest.method = "textDocument/linkedEditingRange";
		LinkedEditingRangeRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		LinkedEditingRangeRequest.type = new messages_1.ProtocolRequestType(LinkedEditingRangeRequest.method);
		LinkedEditingRangeRequest.capabilities = messages_1.CM.create("textDocument.linkedEditingRange", "linkedEditingRangeProvider");
	})(LinkedEditingRangeRequest || (exports.LinkedEditingRangeRequest = LinkedEditingRangeRequest = {}));
}));
// node_modules/vscode-languageserver-protocol/lib/common/protocol.fileOperations.js
var require_protocol_fileOperations = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.WillDeleteFilesRequest = exports.DidDeleteFilesNotification = exports.DidRenameFilesNotification = exports.WillRenameFilesRequest = exports.DidCreateFilesNotification = exports.WillCreateFilesRequest = exports.FileOperationPatternKind = void 0;
	var messages_1 = require_messages();
	/**
	* A pattern kind describing if a glob pattern matches a file a folder or
	* both.
	*
	* @since 3.16.0
	*/
	var FileOperationPatternKind;
	(function(FileOperationPatternKind) {
		/**
		* The pattern matches a file only.
		*/
		FileOperationPatternKind.file = "file";
		/**
		* The pattern matches a folder only.
		*/
		FileOperationPatternKind.folder = "folder";
	})(FileOperationPatternKind || (exports.FileOperationPatternKind = FileOperationPatternKind = {}));
	/**
	* The will create files request is sent from the client to the server before files are actually
	* created as long as the creation is triggered from within the client.
	*
	* The request can return a `WorkspaceEdit` which will be applied to workspace before the
	* files are created. Hence the `WorkspaceEdit` can not manipulate the content of the file
	* to be created.
	*
	* @since 3.16.0
	*/
	var WillCreateFilesRequest;
	(function(WillCreateFilesRequest) {
		WillCreateFilesRequest.method = "workspace/willCreateFiles";
		WillCreateFilesRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		WillCreateFilesRequest.type = new messages_1.ProtocolRequestType(WillCreateFilesRequest.method);
		WillCreateFilesRequest.capabilities = messages_1.CM.create("workspace.fileOperations.willCreate", "workspace.fileOperations.willCreate");
	})(WillCreateFilesRequest || (exports.WillCreateFilesRequest = WillCreateFilesRequest = {}));
	/**
	* The did create files notification is sent from the client to the server when
	* files were created from within the client.
	*
	* @since 3.16.0
	*/
	var DidCreateFilesNotification;
	(function(DidCreateFilesNotification) {
		DidCreateFilesNotification.method = "workspace/didCreateFiles";
		DidCreateFilesNotification.messageDirection = messages_1.MessageDirection.clientToServer;
		DidCreateFilesNotification.type = new messages_1.ProtocolNotificationType(DidCreateFilesNotification.method);
		DidCreateFilesNotification.capabilities = messages_1.CM.create("workspace.fileOperations.didCreate", "workspace.fileOperations.didCreate");
	})(DidCreateFilesNotification || (exports.DidCreateFilesNotification = DidCreateFilesNotification = {}));
	/**
	* The will rename files request is sent from the client to the server before files are actually
	* renamed as long as the rename is triggered from within the client.
	*
	* @since 3.16.0
	*/
	var WillRenameFilesRequest;
	(function(WillRenameFilesRequest) {
		WillRenameFilesRequest.method = "workspace/willRenameFiles";
		WillRenameFilesRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		WillRenameFilesRequest.type = new messages_1.ProtocolRequestType(WillRenameFilesRequest.method);
		WillRenameFilesRequest.capabilities = messages_1.CM.create("workspace.fileOperations.willRename", "workspace.fileOperations.willRename");
	})(WillRenameFilesRequest || (exports.WillRenameFilesRequest = WillRenameFilesRequest = {}));
	/**
	* The did rename files notification is sent from the client to the server when
	* files were renamed from within the client.
	*
	* @since 3.16.0
	*/
	var DidRenameFilesNotification;
	(function(DidRenameFilesNotification) {
		DidRenameFilesNotification.method = "workspace/didRenameFiles";
		DidRenameFilesNotification.messageDirection = messages_1.MessageDirection.clientToServer;
		DidRenameFilesNotification.type = new messages_1.ProtocolNotificationType(DidRenameFilesNotification.method);
		DidRenameFilesNotification.capabilities = messages_1.CM.create("workspace.fileOperations.didRename", "workspace.fileOperations.didRename");
	})(DidRenameFilesNotification || (exports.DidRenameFilesNotification = DidRenameFilesNotification = {}));
	/**
	* The will delete files request is sent from the client to the server before files are actually
	* deleted as long as the deletion is triggered from within the client.
	*
	* @since 3.16.0
	*/
	var DidDeleteFilesNotification;
	(function(DidDeleteFilesNotification) {
		DidDeleteFilesNotification.method = "workspace/didDeleteFiles";
		DidDeleteFilesNotification.messageDirection = messages_1.MessageDirection.clientToServer;
		DidDeleteFilesNotification.type = new messages_1.ProtocolNotificationType(DidDeleteFilesNotification.method);
		DidDeleteFilesNotification.capabilities = messages_1.CM.create("workspace.fileOperations.didDelete", "workspace.fileOperations.didDelete");
	})(DidDeleteFilesNotification || (exports.DidDeleteFilesNotification = DidDeleteFilesNotification = {}));
	/**
	* The did delete files notification is sent from the client to the server when
	* files were deleted from within the client.
	*
	* @since 3.16.0
	*/
	var WillDeleteFilesRequest;
	(function(WillDeleteFilesRequest) {
		WillDeleteFilesRequest.method = "workspace/willDeleteFiles";
		WillDeleteFilesRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		WillDeleteFilesRequest.type = new messages_1.ProtocolRequestType(WillDeleteFilesRequest.method);
		WillDeleteFilesRequest.capabilities = messages_1.CM.create("workspace.fileOperations.willDelete", "workspace.fileOperations.willDelete");
	})(WillDeleteFilesRequest || (exports.WillDeleteFilesRequest = WillDeleteFilesRequest = {}));
}));
// node_modules/vscode-languageserver-protocol/lib/common/protocol.moniker.js
var require_protocol_moniker = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.MonikerRequest = exports.MonikerKind = exports.UniquenessLevel = void 0;
	var messages_1 = require_messages();
	/**
	* Moniker uniqueness level to define scope of the moniker.
	*
	* @since 3.16.0
	*/
	var UniquenessLevel;
	(function(UniquenessLevel) {
		/**
		* The moniker is only unique inside a document
		*/
		UniquenessLevel.document = "document";
		/**
		* The moniker is unique inside a project for which a dump got created
		*/
		UniquenessLevel.project = "project";
		/**
		* The moniker is unique inside the group to which a project belongs
		*/
		UniquenessLevel.group = "group";
		/**
		* The moniker is unique inside the moniker scheme.
		*/
		UniquenessLevel.scheme = "scheme";
		/**
		* The moniker is globally unique
		*/
		UniquenessLevel.global = "global";
	})(UniquenessLevel || (exports.UniquenessLevel = UniquenessLevel = {}));
	/**
	* The moniker kind.
	*
	* @since 3.16.0
	*/
	var MonikerKind;
	(function(MonikerKind) {
		/**
		* The moniker represent a symbol that is imported into a project
		*/
		MonikerKind.$import = "import";
		/**
		* The moniker represents a symbol that is exported from a project
		*/
		MonikerKind.$export = "export";
		/**
		* The moniker represents a symbol that is local to a project (e.g. a local
		* variable of a function, a class not visible outside the project, ...)
		*/
		MonikerKind.local = "local";
	})(MonikerKind || (exports.MonikerKind = MonikerKind = {}));
	/**
	* A request to get the moniker of a symbol at a given text document position.
	* The request parameter is of type {@link TextDocumentPositionParams}.
	* The response is of type {@link Moniker Moniker[]} or `null`.
	*/
	var MonikerRequest;
	(function(MonikerRequest) {
		MonikerRequest.method = "textDocument/moniker";
		MonikerRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		MonikerRequest.type = new messages_1.ProtocolRequestType(MonikerRequest.method);
		MonikerRequest.capabilities = messages_1.CM.create("textDocument.moniker", "monikerProvider");
	})(MonikerRequest || (exports.MonikerRequest = MonikerRequest = {}));
}));
// node_modules/vscode-languageserver-protocol/lib/common/protocol.typeHierarchy.js
var require_protocol_typeHierarchy = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.TypeHierarchySubtypesRequest = exports.TypeHierarchySupertypesRequest = exports.TypeHierarchyPrepareRequest = void 0;
	var messages_1 = require_messages();
	/**
	* A request to result a `TypeHierarchyItem` in a document at a given position.
	* Can be used as an input to a subtypes or supertypes type hierarchy.
	*
	* @since 3.17.0
	*/
	var TypeHierarchyPrepareRequest;
	(function(TypeHierarchyPrepareRequest) {
		TypeHierarchyPrepareRequest.method = "textDocument/prepareTypeHierarchy";
		TypeHierarchyPrepareRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		TypeHierarchyPrepareRequest.type = new messages_1.ProtocolRequestType(TypeHierarchyPrepareRequest.method);
		TypeHierarchyPrepareRequest.capabilities = messages_1.CM.create("textDocument.typeHierarchy", "typeHierarchyProvider");
	})(TypeHierarchyPrepareRequest || (exports.TypeHierarchyPrepareRequest = TypeHierarchyPrepareRequest = {}));
	/**
	* A request to resolve the supertypes for a given `TypeHierarchyItem`.
	*
	* @since 3.17.0
	*/
	var TypeHierarchySupertypesRequest;
	(function(TypeHierarchySupertypesRequest) {
		TypeHierarchySupertypesRequest.method = "typeHierarchy/supertypes";
		TypeHierarchySupertypesRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		TypeHierarchySupertypesRequest.type = new messages_1.ProtocolRequestType(TypeHierarchySupertypesRequest.method);
	})(TypeHierarchySupertypesRequest || (exports.TypeHierarchySupertypesRequest = TypeHierarchySupertypesRequest = {}));
	/**
	* A request to resolve the subtypes for a given `TypeHierarchyItem`.
	*
	* @since 3.17.0
	*/
	var TypeHierarchySubtypesRequest;
	(function(TypeHierarchySubtypesRequest) {
		TypeHierarchySubtypesRequest.method = "typeHierarchy/subtypes";
		TypeHierarchySubtypesRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		TypeHierarchySubtypesRequest.type = new messages_1.ProtocolRequestType(TypeHierarchySubtypesRequest.method);
	})(TypeHierarchySubtypesRequest || (exports.TypeHierarchySubtypesRequest = TypeHierarchySubtypesRequest = {}));
}));
// node_modules/vscode-languageserver-protocol/lib/common/protocol.inlineValue.js
var require_protocol_inlineValue = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.InlineValueRefreshRequest = exports.InlineValueRequest = void 0;
	var messages_1 = require_messages();
	/**
	* A request to provide inline values in a document. The request's parameter is of
	* type {@link InlineValueParams}, the response is of type
	* {@link InlineValue InlineValue[]} or a Thenable that resolves to such.
	*
	* @since 3.17.0
	*/
	var InlineValueRequest;
	(function(InlineValueRequest) {
		InlineValueRequest.method = "textDocument/inlineValue";
		InlineValueRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		InlineValueRequest.type = new messages_1.ProtocolRequestType(InlineValueRequest.method);
		InlineValueRequest.capabilities = messages_1.CM.create("textDocument.inlineValue", "inlineValueProvider");
	})(InlineValueRequest || (exports.InlineValueRequest = InlineValueRequest = {}));
	/**
	* @since 3.17.0
	*/
	var InlineValueRefreshRequest;
	(function(InlineValueRefreshRequest) {
		InlineValueRefreshRequest.method = `workspace/inlineValue/refresh`;
		InlineValueRefreshRequest.messageDirection = messages_1.MessageDirection.serverToClient;
		InlineValueRefreshRequest.type = new messages_1.ProtocolRequestType0(InlineValueRefreshRequest.method);
		InlineValueRefreshRequest.capabilities = messages_1.CM.create("workspace.inlineValue.refreshSupport", void 0);
	})(InlineValueRefreshRequest || (exports.InlineValueRefreshRequest = InlineValueRefreshRequest = {}));
}));
// node_modules/vscode-languageserver-protocol/lib/common/protocol.inlayHint.js
var require_protocol_inlayHint = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.InlayHintRefreshRequest = exports.InlayHintResolveRequest = exports.InlayHintRequest = void 0;
	var messages_1 = require_messages();
	/**
	* A request to provide inlay hints in a document. The request's parameter is of
	* type {@link InlayHintsParams}, the response is of type
	* {@link InlayHint InlayHint[]} or a Thenable that resolves to such.
	*
	* @since 3.17.0
	*/
	var InlayHintRequest;
	(function(InlayHintRequest) {
		InlayHintRequest.method = "textDocument/inlayHint";
		InlayHintRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		InlayHintRequest.type = new messages_1.ProtocolRequestType(InlayHintRequest.method);
		InlayHintRequest.capabilities = messages_1.CM.create("textDocument.inlayHint", "inlayHintProvider");
	})(InlayHintRequest || (exports.InlayHintRequest = InlayHintRequest = {}));
	/**
	* A request to resolve additional properties for an inlay hint.
	* The request's parameter is of type {@link InlayHint}, the response is
	* of type {@link InlayHint} or a Thenable that resolves to such.
	*
	* @since 3.17.0
	*/
	var InlayHintResolveRequest;
	(function(InlayHintResolveRequest) {
		InlayHintResolveRequest.method = "inlayHint/resolve";
		InlayHintResolveRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		InlayHintResolveRequest.type = new messages_1.ProtocolRequestType(InlayHintResolveRequest.method);
		InlayHintResolveRequest.capabilities = messages_1.CM.create("textDocument.inlayHint.resolveSupport", "inlayHintProvider.resolveProvider");
	})(InlayHintResolveRequest || (exports.InlayHintResolveRequest = InlayHintResolveRequest = {}));
	/**
	* @since 3.17.0
	*/
	var InlayHintRefreshRequest;
	(function(InlayHintRefreshRequest) {
		InlayHintRefreshRequest.method = `workspace/inlayHint/refresh`;
		InlayHintRefreshRequest.messageDirection = messages_1.MessageDirection.serverToClient;
		InlayHintRefreshRequest.type = new messages_1.ProtocolRequestType0(InlayHintRefreshRequest.method);
		InlayHintRefreshRequest.capabilities = messages_1.CM.create("workspace.inlayHint.refreshSupport", void 0);
	})(InlayHintRefreshRequest || (exports.InlayHintRefreshRequest = InlayHintRefreshRequest = {}));
}));
// node_modules/vscode-languageserver-protocol/lib/common/protocol.diagnostic.js
var require_protocol_diagnostic = /* @__PURE__ */ __commonJSMin(((exports, module, this$31) => {
	var __createBinding = this$31 && this$31.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$31 && this$31.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$31 && this$31.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.DiagnosticRefreshRequest = exports.WorkspaceDiagnosticRequest = exports.DocumentDiagnosticRequest = exports.DocumentDiagnosticReportKind = exports.DiagnosticServerCancellationData = void 0;
	var vscode_jsonrpc_1 = require_api$2();
	var Is = __importStar(require_is());
	var messages_1 = require_messages();
	/**
	* @since 3.17.0
	*/
	var DiagnosticServerCancellationData;
	(function(DiagnosticServerCancellationData) {
		function is(value) {
			const candidate = value;
			return candidate && Is.boolean(candidate.retriggerRequest);
		}
		DiagnosticServerCancellationData.is = is;
	})(DiagnosticServerCancellationData || (exports.DiagnosticServerCancellationData = DiagnosticServerCancellationData = {}));
	/**
	* The document diagnostic report kinds.
	*
	* @since 3.17.0
	*/
	var DocumentDiagnosticReportKind;
	(function(DocumentDiagnosticReportKind) {
		/**
		* A diagnostic report with a full
		* set of problems.
		*/
		DocumentDiagnosticReportKind.Full = "full";
		/**
		* A report indicating that the last
		* returned report is still accurate.
		*/
		DocumentDiagnosticReportKind.Unchanged = "unchanged";
	})(DocumentDiagnosticReportKind || (exports.DocumentDiagnosticReportKind = DocumentDiagnosticReportKind = {}));
	/**
	* The document diagnostic request definition.
	*
	*
	* @since 3.17.0
	*/
	var DocumentDiagnosticRequest;
	(function(DocumentDiagnosticRequest) {
		DocumentDiagnosticRequest.method = "textDocument/diagnostic";
		DocumentDiagnosticRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		DocumentDiagnosticRequest.type = new messages_1.ProtocolRequestType(DocumentDiagnosticRequest.method);
		DocumentDiagnosticRequest.partialResult = new vscode_jsonrpc_1.ProgressType();
		DocumentDiagnosticRequest.capabilities = messages_1.CM.create("textDocument.diagnostic", "diagnosticProvider");
	})(DocumentDiagnosticRequest || (exports.DocumentDiagnosticRequest = DocumentDiagnosticRequest = {}));
	/**
	* The workspace diagnostic request definition.
	*
	* @since 3.17.0
	*/
	var WorkspaceDiagnosticRequest;
	(function(WorkspaceDiagnosticRequest) {
		WorkspaceDiagnosticRequest.method = "workspace/diagnostic";
		WorkspaceDiagnosticRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		WorkspaceDiagnosticRequest.type = new messages_1.ProtocolRequestType(WorkspaceDiagnosticRequest.method);
		WorkspaceDiagnosticRequest.partialResult = new vscode_jsonrpc_1.ProgressType();
		WorkspaceDiagnosticRequest.capabilities = messages_1.CM.create("workspace.diagnostics", "diagnosticProvider.workspaceDiagnostics");
	})(WorkspaceDiagnosticRequest || (exports.WorkspaceDiagnosticRequest = WorkspaceDiagnosticRequest = {}));
	/**
	* The diagnostic refresh request definition.
	*
	* @since 3.17.0
	*/
	var DiagnosticRefreshRequest;
	(function(DiagnosticRefreshRequest) {
		DiagnosticRefreshRequest.method = `workspace/diagnostic/refresh`;
		DiagnosticRefreshRequest.messageDirection = messages_1.MessageDirection.serverToClient;
		DiagnosticRefreshRequest.type = new messages_1.ProtocolRequestType0(DiagnosticRefreshRequest.method);
		DiagnosticRefreshRequest.capabilities = messages_1.CM.create("workspace.diagnostics.refreshSupport", void 0);
	})(DiagnosticRefreshRequest || (exports.DiagnosticRefreshRequest = DiagnosticRefreshRequest = {}));
}));
// node_modules/vscode-languageserver-protocol/lib/common/protocol.notebook.js
var require_protocol_notebook = /* @__PURE__ */ __commonJSMin(((exports, module, this$30) => {
	var __createBinding = this$30 && this$30.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$30 && this$30.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$30 && this$30.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.DidCloseNotebookDocumentNotification = exports.DidSaveNotebookDocumentNotification = exports.DidChangeNotebookDocumentNotification = exports.NotebookCellArrayChange = exports.DidOpenNotebookDocumentNotification = exports.NotebookDocumentSyncRegistrationType = exports.NotebookDocument = exports.NotebookCell = exports.ExecutionSummary = exports.NotebookCellKind = void 0;
	var vscode_languageserver_types_1 = (init_main$1(), __toCommonJS(main_exports$1));
	var Is = __importStar(require_is());
	var messages_1 = require_messages();
	/**
	* A notebook cell kind.
	*
	* @since 3.17.0
	*/
	var NotebookCellKind;
	(function(NotebookCellKind) {
		/**
		* A markup-cell is formatted source that is used for display.
		*/
		NotebookCellKind.Markup = 1;
		/**
		* A code-cell is source code.
		*/
		NotebookCellKind.Code = 2;
		function is(value) {
			return value === 1 || value === 2;
		}
		NotebookCellKind.is = is;
	})(NotebookCellKind || (exports.NotebookCellKind = NotebookCellKind = {}));
	var ExecutionSummary;
	(function(ExecutionSummary) {
		function create(executionOrder, success) {
			const result = { executionOrder };
			if (success === true || success === false) result.success = success;
			return result;
		}
		ExecutionSummary.create = create;
		function is(value) {
			const candidate = value;
			return Is.objectLiteral(candidate) && vscode_languageserver_types_1.uinteger.is(candidate.executionOrder) && (candidate.success === void 0 || Is.boolean(candidate.success));
		}
		ExecutionSummary.is = is;
		function equals(one, other) {
			if (one === other) return true;
			if (one === null || one === void 0 || other === null || other === void 0) return false;
			return one.executionOrder === other.executionOrder && one.success === other.success;
		}
		ExecutionSummary.equals = equals;
	})(ExecutionSummary || (exports.ExecutionSummary = ExecutionSummary = {}));
	var NotebookCell;
	(function(NotebookCell) {
		function create(kind, document) {
			return {
				kind,
				document
			};
		}
		NotebookCell.create = create;
		function is(value) {
			const candidate = value;
			return Is.objectLiteral(candidate) && NotebookCellKind.is(candidate.kind) && vscode_languageserver_types_1.DocumentUri.is(candidate.document) && (candidate.metadata === void 0 || Is.objectLiteral(candidate.metadata));
		}
		NotebookCell.is = is;
		function diff(one, two) {
			const result = /* @__PURE__ */ new Set();
			if (one.document !== two.document) result.add("document");
			if (one.kind !== two.kind) result.add("kind");
			if (one.executionSummary !== two.executionSummary) result.add("executionSummary");
			if ((one.metadata !== void 0 || two.metadata !== void 0) && !equalsMetadata(one.metadata, two.metadata)) result.add("metadata");
			if ((one.executionSummary !== void 0 || two.executionSummary !== void 0) && !ExecutionSummary.equals(one.executionSummary, two.executionSummary)) result.add("executionSummary");
			return result;
		}
		NotebookCell.diff = diff;
		function equalsMetadata(one, other) {
			if (one === other) return true;
			if (one === null || one === void 0 || other === null || other === void 0) return false;
			if (typeof one !== typeof other) return false;
			if (typeof one !== "object") return false;
			const oneArray = Array.isArray(one);
			const otherArray = Array.isArray(other);
			if (oneArray !== otherArray) return false;
			if (oneArray && otherArray) {
				if (one.length !== other.length) return false;
				for (let i = 0; i < one.length; i++) if (!equalsMetadata(one[i], other[i])) return false;
			}
			if (Is.objectLiteral(one) && Is.objectLiteral(other)) {
				const oneKeys = Object.keys(one);
				const otherKeys = Object.keys(other);
				if (oneKeys.length !== otherKeys.length) return false;
				oneKeys.sort();
				otherKeys.sort();
				if (!equalsMetadata(oneKeys, otherKeys)) return false;
				for (let i = 0; i < oneKeys.length; i++) {
					const prop = oneKeys[i];
					if (!equalsMetadata(one[prop], other[prop])) return false;
				}
			}
			return true;
		}
	})(NotebookCell || (exports.NotebookCell = NotebookCell = {}));
	var NotebookDocument;
	(function(NotebookDocument) {
		function create(uri, notebookType, version, cells) {
			return {
				uri,
				notebookType,
				version,
				cells
			};
		}
		NotebookDocument.create = create;
		function is(value) {
			const candidate = value;
			return Is.objectLiteral(candidate) && Is.string(candidate.uri) && vscode_languageserver_types_1.integer.is(candidate.version) && Is.typedArray(candidate.cells, NotebookCell.is);
		}
		NotebookDocument.is = is;
	})(NotebookDocument || (exports.NotebookDocument = NotebookDocument = {}));
	var NotebookDocumentSyncRegistrationType;
	(function(NotebookDocumentSyncRegistrationType) {
		NotebookDocumentSyncRegistrationType.method = "notebookDocument/sync";
		NotebookDocumentSyncRegistrationType.messageDirection = messages_1.MessageDirection.clientToServer;
		NotebookDocumentSyncRegistrationType.type = new messages_1.RegistrationType(NotebookDocumentSyncRegistrationType.method);
	})(NotebookDocumentSyncRegistrationType || (exports.NotebookDocumentSyncRegistrationType = NotebookDocumentSyncRegistrationType = {}));
	/**
	* A notification sent when a notebook opens.
	*
	* @since 3.17.0
	*/
	var DidOpenNotebookDocumentNotification;
	(function(DidOpenNotebookDocumentNotification) {
		DidOpenNotebookDocumentNotification.method = "notebookDocument/didOpen";
		DidOpenNotebookDocumentNotification.messageDirection = messages_1.MessageDirection.clientToServer;
		DidOpenNotebookDocumentNotification.type = new messages_1.ProtocolNotificationType(DidOpenNotebookDocumentNotification.method);
		DidOpenNotebookDocumentNotification.registrationMethod = NotebookDocumentSyncRegistrationType.method;
	})(DidOpenNotebookDocumentNotification || (exports.DidOpenNotebookDocumentNotification = DidOpenNotebookDocumentNotification = {}));
	var NotebookCellArrayChange;
	(function(NotebookCellArrayChange) {
		function is(value) {
			const candidate = value;
			return Is.objectLiteral(candidate) && vscode_languageserver_types_1.uinteger.is(candidate.start) && vscode_languageserver_types_1.uinteger.is(candidate.deleteCount) && (candidate.cells === void 0 || Is.typedArray(candidate.cells, NotebookCell.is));
		}
		NotebookCellArrayChange.is = is;
		function create(start, deleteCount, cells) {
			const result = {
				start,
				deleteCount
			};
			if (cells !== void 0) result.cells = cells;
			return result;
		}
		NotebookCellArrayChange.create = create;
	})(NotebookCellArrayChange || (exports.NotebookCellArrayChange = NotebookCellArrayChange = {}));
	var DidChangeNotebookDocumentNotification;
	(function(DidChangeNotebookDocumentNotification) {
		DidChangeNotebookDocumentNotification.method = "notebookDocument/didChange";
		DidChangeNotebookDocumentNotification.messageDirection = messages_1.MessageDirection.clientToServer;
		DidChangeNotebookDocumentNotification.type = new messages_1.ProtocolNotificationType(DidChangeNotebookDocumentNotification.method);
		DidChangeNotebookDocumentNotification.registrationMethod = NotebookDocumentSyncRegistrationType.method;
	})(DidChangeNotebookDocumentNotification || (exports.DidChangeNotebookDocumentNotification = DidChangeNotebookDocumentNotification = {}));
	/**
	* A notification sent when a notebook document is saved.
	*
	* @since 3.17.0
	*/
	var DidSaveNotebookDocumentNotification;
	(function(DidSaveNotebookDocumentNotification) {
		DidSaveNotebookDocumentNotification.method = "notebookDocument/didSave";
		DidSaveNotebookDocumentNotification.messageDirection = messages_1.MessageDirection.clientToServer;
		DidSaveNotebookDocumentNotification.type = new messages_1.ProtocolNotificationType(DidSaveNotebookDocumentNotification.method);
		DidSaveNotebookDocumentNotification.registrationMethod = NotebookDocumentSyncRegistrationType.method;
	})(DidSaveNotebookDocumentNotification || (exports.DidSaveNotebookDocumentNotification = DidSaveNotebookDocumentNotification = {}));
	/**
	* A notification sent when a notebook closes.
	*
	* @since 3.17.0
	*/
	var DidCloseNotebookDocumentNotification;
	(function(DidCloseNotebookDocumentNotification) {
		DidCloseNotebookDocumentNotification.method = "notebookDocument/didClose";
		DidCloseNotebookDocumentNotification.messageDirection = messages_1.MessageDirection.clientToServer;
		DidCloseNotebookDocumentNotification.type = new messages_1.ProtocolNotificationType(DidCloseNotebookDocumentNotification.method);
		DidCloseNotebookDocumentNotification.registrationMethod = NotebookDocumentSyncRegistrationType.method;
	})(DidCloseNotebookDocumentNotification || (exports.DidCloseNotebookDocumentNotification = DidCloseNotebookDocumentNotification = {}));
}));
// node_modules/vscode-languageserver-protocol/lib/common/protocol.inlineCompletion.js
var require_protocol_inlineCompletion = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.InlineCompletionRequest = void 0;
	var messages_1 = require_messages();
	/**
	* A request to provide inline completions in a document. The request's parameter is of
	* type {@link InlineCompletionParams}, the response is of type
	* {@link InlineCompletion InlineCompletion[]} or a Thenable that resolves to such.
	*
	* @since 3.18.0
	*/
	var InlineCompletionRequest;
	(function(InlineCompletionRequest) {
		InlineCompletionRequest.method = "textDocument/inlineCompletion";
		InlineCompletionRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		InlineCompletionRequest.type = new messages_1.ProtocolRequestType(InlineCompletionRequest.method);
		InlineCompletionRequest.capabilities = messages_1.CM.create("textDocument.inlineCompletion", "inlineCompletionProvider");
	})(InlineCompletionRequest || (exports.InlineCompletionRequest = InlineCompletionRequest = {}));
}));
// node_modules/vscode-languageserver-protocol/lib/common/protocol.textDocumentContent.js
var require_protocol_textDocumentContent = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.TextDocumentContentRefreshRequest = exports.TextDocumentContentRequest = void 0;
	var messages_1 = require_messages();
	/**
	* The `workspace/textDocumentContent` request is sent from the client to the
	* server to request the content of a text document.
	*
	* @since 3.18.0
	*/
	var TextDocumentContentRequest;
	(function(TextDocumentContentRequest) {
		TextDocumentContentRequest.method = "workspace/textDocumentContent";
		TextDocumentContentRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		TextDocumentContentRequest.type = new messages_1.ProtocolRequestType(TextDocumentContentRequest.method);
		TextDocumentContentRequest.capabilities = messages_1.CM.create("workspace.textDocumentContent", "workspace.textDocumentContent");
	})(TextDocumentContentRequest || (exports.TextDocumentContentRequest = TextDocumentContentRequest = {}));
	/**
	* The `workspace/textDocumentContent` request is sent from the server to the client to refresh
	* the content of a specific text document.
	*
	* @since 3.18.0
	*/
	var TextDocumentContentRefreshRequest;
	(function(TextDocumentContentRefreshRequest) {
		TextDocumentContentRefreshRequest.method = `workspace/textDocumentContent/refresh`;
		TextDocumentContentRefreshRequest.messageDirection = messages_1.MessageDirection.serverToClient;
		TextDocumentContentRefreshRequest.type = new messages_1.ProtocolRequestType(TextDocumentContentRefreshRequest.method);
	})(TextDocumentContentRefreshRequest || (exports.TextDocumentContentRefreshRequest = TextDocumentContentRefreshRequest = {}));
}));
// node_modules/vscode-languageserver-protocol/lib/common/protocol.js
var require_protocol = /* @__PURE__ */ __commonJSMin(((exports, module, this$29) => {
	var __createBinding = this$29 && this$29.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$29 && this$29.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$29 && this$29.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.CodeActionRequest = exports.DocumentSymbolRequest = exports.DocumentHighlightRequest = exports.ReferencesRequest = exports.DefinitionRequest = exports.SignatureHelpRequest = exports.SignatureHelpTriggerKind = exports.HoverRequest = exports.CompletionResolveRequest = exports.CompletionRequest = exports.CompletionTriggerKind = exports.PublishDiagnosticsNotification = exports.WatchKind = exports.GlobPattern = exports.RelativePattern = exports.FileChangeType = exports.DidChangeWatchedFilesNotification = exports.WillSaveTextDocumentWaitUntilRequest = exports.WillSaveTextDocumentNotification = exports.TextDocumentSaveReason = exports.DidSaveTextDocumentNotification = exports.DidCloseTextDocumentNotification = exports.DidChangeTextDocumentNotification = exports.TextDocumentContentChangeEvent = exports.DidOpenTextDocumentNotification = exports.TextDocumentSyncKind = exports.TelemetryEventNotification = exports.LogMessageNotification = exports.ShowMessageRequest = exports.ShowMessageNotification = exports.MessageType = exports.DidChangeConfigurationNotification = exports.ExitNotification = exports.ShutdownRequest = exports.InitializedNotification = exports.InitializeErrorCodes = exports.InitializeRequest = exports.WorkDoneProgressOptions = exports.TextDocumentRegistrationOptions = exports.StaticRegistrationOptions = exports.PositionEncodingKind = exports.RegularExpressionEngineKind = exports.FailureHandlingKind = exports.ResourceOperationKind = exports.UnregistrationRequest = exports.RegistrationRequest = exports.DocumentSelector = exports.NotebookCellTextDocumentFilter = exports.NotebookDocumentFilter = exports.TextDocumentFilter = void 0;
	exports.UniquenessLevel = exports.WillDeleteFilesRequest = exports.DidDeleteFilesNotification = exports.WillRenameFilesRequest = exports.DidRenameFilesNotification = exports.WillCreateFilesRequest = exports.DidCreateFilesNotification = exports.FileOperationPatternKind = exports.LinkedEditingRangeRequest = exports.ShowDocumentRequest = exports.SemanticTokensRegistrationType = exports.SemanticTokensRefreshRequest = exports.SemanticTokensRangeRequest = exports.SemanticTokensDeltaRequest = exports.SemanticTokensRequest = exports.TokenFormat = exports.CallHierarchyPrepareRequest = exports.CallHierarchyOutgoingCallsRequest = exports.CallHierarchyIncomingCallsRequest = exports.WorkDoneProgressCancelNotification = exports.WorkDoneProgressCreateRequest = exports.WorkDoneProgress = exports.SelectionRangeRequest = exports.DeclarationRequest = exports.FoldingRangeRefreshRequest = exports.FoldingRangeRequest = exports.ColorPresentationRequest = exports.DocumentColorRequest = exports.ConfigurationRequest = exports.DidChangeWorkspaceFoldersNotification = exports.WorkspaceFoldersRequest = exports.TypeDefinitionRequest = exports.ImplementationRequest = exports.ApplyWorkspaceEditRequest = exports.ExecuteCommandRequest = exports.PrepareRenameRequest = exports.RenameRequest = exports.PrepareSupportDefaultBehavior = exports.DocumentOnTypeFormattingRequest = exports.DocumentRangesFormattingRequest = exports.DocumentRangeFormattingRequest = exports.DocumentFormattingRequest = exports.DocumentLinkResolveRequest = exports.DocumentLinkRequest = exports.CodeLensRefreshRequest = exports.CodeLensResolveRequest = exports.CodeLensRequest = exports.WorkspaceSymbolResolveRequest = exports.WorkspaceSymbolRequest = exports.CodeActionResolveRequest = void 0;
	exports.TextDocumentContentRefreshRequest = exports.TextDocumentContentRequest = exports.InlineCompletionRequest = exports.DidCloseNotebookDocumentNotification = exports.DidSaveNotebookDocumentNotification = exports.DidChangeNotebookDocumentNotification = exports.NotebookCellArrayChange = exports.DidOpenNotebookDocumentNotification = exports.NotebookDocumentSyncRegistrationType = exports.NotebookDocument = exports.NotebookCell = exports.ExecutionSummary = exports.NotebookCellKind = exports.DiagnosticRefreshRequest = exports.WorkspaceDiagnosticRequest = exports.DocumentDiagnosticRequest = exports.DocumentDiagnosticReportKind = exports.DiagnosticServerCancellationData = exports.InlayHintRefreshRequest = exports.InlayHintResolveRequest = exports.InlayHintRequest = exports.InlineValueRefreshRequest = exports.InlineValueRequest = exports.TypeHierarchySupertypesRequest = exports.TypeHierarchySubtypesRequest = exports.TypeHierarchyPrepareRequest = exports.MonikerRequest = exports.MonikerKind = void 0;
	var messages_1 = require_messages();
	var vscode_languageserver_types_1 = (init_main$1(), __toCommonJS(main_exports$1));
	var Is = __importStar(require_is());
	var protocol_implementation_1 = require_protocol_implementation();
	Object.defineProperty(exports, "ImplementationRequest", {
		enumerable: true,
		get: function() {
			return protocol_implementation_1.ImplementationRequest;
		}
	});
	var protocol_typeDefinition_1 = require_protocol_typeDefinition();
	Object.defineProperty(exports, "TypeDefinitionRequest", {
		enumerable: true,
		get: function() {
			return protocol_typeDefinition_1.TypeDefinitionRequest;
		}
	});
	var protocol_workspaceFolder_1 = require_protocol_workspaceFolder();
	Object.defineProperty(exports, "WorkspaceFoldersRequest", {
		enumerable: true,
		get: function() {
			return protocol_workspaceFolder_1.WorkspaceFoldersRequest;
		}
	});
	Object.defineProperty(exports, "DidChangeWorkspaceFoldersNotification", {
		enumerable: true,
		get: function() {
			return protocol_workspaceFolder_1.DidChangeWorkspaceFoldersNotification;
		}
	});
	var protocol_configuration_1 = require_protocol_configuration();
	Object.defineProperty(exports, "ConfigurationRequest", {
		enumerable: true,
		get: function() {
			return protocol_configuration_1.ConfigurationRequest;
		}
	});
	var protocol_colorProvider_1 = require_protocol_colorProvider();
	Object.defineProperty(exports, "DocumentColorRequest", {
		enumerable: true,
		get: function() {
			return protocol_colorProvider_1.DocumentColorRequest;
		}
	});
	Object.defineProperty(exports, "ColorPresentationRequest", {
		enumerable: true,
		get: function() {
			return protocol_colorProvider_1.ColorPresentationRequest;
		}
	});
	var protocol_foldingRange_1 = require_protocol_foldingRange();
	Object.defineProperty(exports, "FoldingRangeRequest", {
		enumerable: true,
		get: function() {
			return protocol_foldingRange_1.FoldingRangeRequest;
		}
	});
	Object.defineProperty(exports, "FoldingRangeRefreshRequest", {
		enumerable: true,
		get: function() {
			return protocol_foldingRange_1.FoldingRangeRefreshRequest;
		}
	});
	var protocol_declaration_1 = require_protocol_declaration();
	Object.defineProperty(exports, "DeclarationRequest", {
		enumerable: true,
		get: function() {
			return protocol_declaration_1.DeclarationRequest;
		}
	});
	var protocol_selectionRange_1 = require_protocol_selectionRange();
	Object.defineProperty(exports, "SelectionRangeRequest", {
		enumerable: true,
		get: function() {
			return protocol_selectionRange_1.SelectionRangeRequest;
		}
	});
	var protocol_progress_1 = require_protocol_progress();
	Object.defineProperty(exports, "WorkDoneProgress", {
		enumerable: true,
		get: function() {
			return protocol_progress_1.WorkDoneProgress;
		}
	});
	Object.defineProperty(exports, "WorkDoneProgressCreateRequest", {
		enumerable: true,
		get: function() {
			return protocol_progress_1.WorkDoneProgressCreateRequest;
		}
	});
	Object.defineProperty(exports, "WorkDoneProgressCancelNotification", {
		enumerable: true,
		get: function() {
			return protocol_progress_1.WorkDoneProgressCancelNotification;
		}
	});
	var protocol_callHierarchy_1 = require_protocol_callHierarchy();
	Object.defineProperty(exports, "CallHierarchyIncomingCallsRequest", {
		enumerable: true,
		get: function() {
			return protocol_callHierarchy_1.CallHierarchyIncomingCallsRequest;
		}
	});
	Object.defineProperty(exports, "CallHierarchyOutgoingCallsRequest", {
		enumerable: true,
		get: function() {
			return protocol_callHierarchy_1.CallHierarchyOutgoingCallsRequest;
		}
	});
	Object.defineProperty(exports, "CallHierarchyPrepareRequest", {
		enumerable: true,
		get: function() {
			return protocol_callHierarchy_1.CallHierarchyPrepareRequest;
		}
	});
	var protocol_semanticTokens_1 = require_protocol_semanticTokens();
	Object.defineProperty(exports, "TokenFormat", {
		enumerable: true,
		get: function() {
			return protocol_semanticTokens_1.TokenFormat;
		}
	});
	Object.defineProperty(exports, "SemanticTokensRequest", {
		enumerable: true,
		get: function() {
			return protocol_semanticTokens_1.SemanticTokensRequest;
		}
	});
	Object.defineProperty(exports, "SemanticTokensDeltaRequest", {
		enumerable: true,
		get: function() {
			return protocol_semanticTokens_1.SemanticTokensDeltaRequest;
		}
	});
	Object.defineProperty(exports, "SemanticTokensRangeRequest", {
		enumerable: true,
		get: function() {
			return protocol_semanticTokens_1.SemanticTokensRangeRequest;
		}
	});
	Object.defineProperty(exports, "SemanticTokensRefreshRequest", {
		enumerable: true,
		get: function() {
			return protocol_semanticTokens_1.SemanticTokensRefreshRequest;
		}
	});
	Object.defineProperty(exports, "SemanticTokensRegistrationType", {
		enumerable: true,
		get: function() {
			return protocol_semanticTokens_1.SemanticTokensRegistrationType;
		}
	});
	var protocol_showDocument_1 = require_protocol_showDocument();
	Object.defineProperty(exports, "ShowDocumentRequest", {
		enumerable: true,
		get: function() {
			return protocol_showDocument_1.ShowDocumentRequest;
		}
	});
	var protocol_linkedEditingRange_1 = require_protocol_linkedEditingRange();
	Object.defineProperty(exports, "LinkedEditingRangeRequest", {
		enumerable: true,
		get: function() {
			return protocol_linkedEditingRange_1.LinkedEditingRangeRequest;
		}
	});
	var protocol_fileOperations_1 = require_protocol_fileOperations();
	Object.defineProperty(exports, "FileOperationPatternKind", {
		enumerable: true,
		get: function() {
			return protocol_fileOperations_1.FileOperationPatternKind;
		}
	});
	Object.defineProperty(exports, "DidCreateFilesNotification", {
		enumerable: true,
		get: function() {
			return protocol_fileOperations_1.DidCreateFilesNotification;
		}
	});
	Object.defineProperty(exports, "WillCreateFilesRequest", {
		enumerable: true,
		get: function() {
			return protocol_fileOperations_1.WillCreateFilesRequest;
		}
	});
	Object.defineProperty(exports, "DidRenameFilesNotification", {
		enumerable: true,
		get: function() {
			return protocol_fileOperations_1.DidRenameFilesNotification;
		}
	});
	Object.defineProperty(exports, "WillRenameFilesRequest", {
		enumerable: true,
		get: function() {
			return protocol_fileOperations_1.WillRenameFilesRequest;
		}
	});
	Object.defineProperty(exports, "DidDeleteFilesNotification", {
		enumerable: true,
		get: function() {
			return protocol_fileOperations_1.DidDeleteFilesNotification;
		}
	});
	Object.defineProperty(exports, "WillDeleteFilesRequest", {
		enumerable: true,
		get: function() {
			return protocol_fileOperations_1.WillDeleteFilesRequest;
		}
	});
	var protocol_moniker_1 = require_protocol_moniker();
	Object.defineProperty(exports, "UniquenessLevel", {
		enumerable: true,
		get: function() {
			return protocol_moniker_1.UniquenessLevel;
		}
	});
	Object.defineProperty(exports, "MonikerKind", {
		enumerable: true,
		get: function() {
			return protocol_moniker_1.MonikerKind;
		}
	});
	Object.defineProperty(exports, "MonikerRequest", {
		enumerable: true,
		get: function() {
			return protocol_moniker_1.MonikerRequest;
		}
	});
	var protocol_typeHierarchy_1 = require_protocol_typeHierarchy();
	Object.defineProperty(exports, "TypeHierarchyPrepareRequest", {
		enumerable: true,
		get: function() {
			return protocol_typeHierarchy_1.TypeHierarchyPrepareRequest;
		}
	});
	Object.defineProperty(exports, "TypeHierarchySubtypesRequest", {
		enumerable: true,
		get: function() {
			return protocol_typeHierarchy_1.TypeHierarchySubtypesRequest;
		}
	});
	Object.defineProperty(exports, "TypeHierarchySupertypesRequest", {
		enumerable: true,
		get: function() {
			return protocol_typeHierarchy_1.TypeHierarchySupertypesRequest;
		}
	});
	var protocol_inlineValue_1 = require_protocol_inlineValue();
	Object.defineProperty(exports, "InlineValueRequest", {
		enumerable: true,
		get: function() {
			return protocol_inlineValue_1.InlineValueRequest;
		}
	});
	Object.defineProperty(exports, "InlineValueRefreshRequest", {
		enumerable: true,
		get: function() {
			return protocol_inlineValue_1.InlineValueRefreshRequest;
		}
	});
	var protocol_inlayHint_1 = require_protocol_inlayHint();
	Object.defineProperty(exports, "InlayHintRequest", {
		enumerable: true,
		get: function() {
			return protocol_inlayHint_1.InlayHintRequest;
		}
	});
	Object.defineProperty(exports, "InlayHintResolveRequest", {
		enumerable: true,
		get: function() {
			return protocol_inlayHint_1.InlayHintResolveRequest;
		}
	});
	Object.defineProperty(exports, "InlayHintRefreshRequest", {
		enumerable: true,
		get: function() {
			return protocol_inlayHint_1.InlayHintRefreshRequest;
		}
	});
	var protocol_diagnostic_1 = require_protocol_diagnostic();
	Object.defineProperty(exports, "DiagnosticServerCancellationData", {
		enumerable: true,
		get: function() {
			return protocol_diagnostic_1.DiagnosticServerCancellationData;
		}
	});
	Object.defineProperty(exports, "DocumentDiagnosticReportKind", {
		enumerable: true,
		get: function() {
			return protocol_diagnostic_1.DocumentDiagnosticReportKind;
		}
	});
	Object.defineProperty(exports, "DocumentDiagnosticRequest", {
		enumerable: true,
		get: function() {
			return protocol_diagnostic_1.DocumentDiagnosticRequest;
		}
	});
	Object.defineProperty(exports, "WorkspaceDiagnosticRequest", {
		enumerable: true,
		get: function() {
			return protocol_diagnostic_1.WorkspaceDiagnosticRequest;
		}
	});
	Object.defineProperty(exports, "DiagnosticRefreshRequest", {
		enumerable: true,
		get: function() {
			return protocol_diagnostic_1.DiagnosticRefreshRequest;
		}
	});
	var protocol_notebook_1 = require_protocol_notebook();
	Object.defineProperty(exports, "NotebookCellKind", {
		enumerable: true,
		get: function() {
			return protocol_notebook_1.NotebookCellKind;
		}
	});
	Object.defineProperty(exports, "ExecutionSummary", {
		enumerable: true,
		get: function() {
			return protocol_notebook_1.ExecutionSummary;
		}
	});
	Object.defineProperty(exports, "NotebookCell", {
		enumerable: true,
		get: function() {
			return protocol_notebook_1.NotebookCell;
		}
	});
	Object.defineProperty(exports, "NotebookDocument", {
		enumerable: true,
		get: function() {
			return protocol_notebook_1.NotebookDocument;
		}
	});
	Object.defineProperty(exports, "NotebookDocumentSyncRegistrationType", {
		enumerable: true,
		get: function() {
			return protocol_notebook_1.NotebookDocumentSyncRegistrationType;
		}
	});
	Object.defineProperty(exports, "DidOpenNotebookDocumentNotification", {
		enumerable: true,
		get: function() {
			return protocol_notebook_1.DidOpenNotebookDocumentNotification;
		}
	});
	Object.defineProperty(exports, "NotebookCellArrayChange", {
		enumerable: true,
		get: function() {
			return protocol_notebook_1.NotebookCellArrayChange;
		}
	});
	Object.defineProperty(exports, "DidChangeNotebookDocumentNotification", {
		enumerable: true,
		get: function() {
			return protocol_notebook_1.DidChangeNotebookDocumentNotification;
		}
	});
	Object.defineProperty(exports, "DidSaveNotebookDocumentNotification", {
		enumerable: true,
		get: function() {
			return protocol_notebook_1.DidSaveNotebookDocumentNotification;
		}
	});
	Object.defineProperty(exports, "DidCloseNotebookDocumentNotification", {
		enumerable: true,
		get: function() {
			return protocol_notebook_1.DidCloseNotebookDocumentNotification;
		}
	});
	var protocol_inlineCompletion_1 = require_protocol_inlineCompletion();
	Object.defineProperty(exports, "InlineCompletionRequest", {
		enumerable: true,
		get: function() {
			return protocol_inlineCompletion_1.InlineCompletionRequest;
		}
	});
	var protocol_textDocumentContent_1 = require_protocol_textDocumentContent();
	Object.defineProperty(exports, "TextDocumentContentRequest", {
		enumerable: true,
		get: function() {
			return protocol_textDocumentContent_1.TextDocumentContentRequest;
		}
	});
	Object.defineProperty(exports, "TextDocumentContentRefreshRequest", {
		enumerable: true,
		get: function() {
			return protocol_textDocumentContent_1.TextDocumentContentRefreshRequest;
		}
	});
	/**
	* The TextDocumentFilter namespace provides helper functions to work with
	* {@link TextDocumentFilter} literals.
	*
	* @since 3.17.0
	*/
	var TextDocumentFilter;
	(function(TextDocumentFilter) {
		function is(value) {
			const candidate = value;
			return Is.string(candidate) || Is.string(candidate.language) || Is.string(candidate.scheme) || GlobPattern.is(candidate.pattern);
		}
		TextDocumentFilter.is = is;
	})(TextDocumentFilter || (exports.TextDocumentFilter = TextDocumentFilter = {}));
	/**
	* The NotebookDocumentFilter namespace provides helper functions to work with
	* {@link NotebookDocumentFilter} literals.
	*
	* @since 3.17.0
	*/
	var NotebookDocumentFilter;
	(function(NotebookDocumentFilter) {
		function is(value) {
			const candidate = value;
			return Is.objectLiteral(candidate) && (Is.string(candidate.notebookType) || Is.string(candidate.scheme) || Is.string(candidate.pattern));
		}
		NotebookDocumentFilter.is = is;
	})(NotebookDocumentFilter || (exports.NotebookDocumentFilter = NotebookDocumentFilter = {}));
	/**
	* The NotebookCellTextDocumentFilter namespace provides helper functions to work with
	* {@link NotebookCellTextDocumentFilter} literals.
	*
	* @since 3.17.0
	*/
	var NotebookCellTextDocumentFilter;
	(function(NotebookCellTextDocumentFilter) {
		function is(value) {
			const candidate = value;
			return Is.objectLiteral(candidate) && (Is.string(candidate.notebook) || NotebookDocumentFilter.is(candidate.notebook)) && (candidate.language === void 0 || Is.string(candidate.language));
		}
		NotebookCellTextDocumentFilter.is = is;
	})(NotebookCellTextDocumentFilter || (exports.NotebookCellTextDocumentFilter = NotebookCellTextDocumentFilter = {}));
	/**
	* The DocumentSelector namespace provides helper functions to work with
	* {@link DocumentSelector}s.
	*/
	var DocumentSelector;
	(function(DocumentSelector) {
		function is(value) {
			if (!Array.isArray(value)) return false;
			for (const elem of value) if (!Is.string(elem) && !TextDocumentFilter.is(elem) && !NotebookCellTextDocumentFilter.is(elem)) return false;
			return true;
		}
		DocumentSelector.is = is;
	})(DocumentSelector || (exports.DocumentSelector = DocumentSelector = {}));
	/**
	* The `client/registerCapability` request is sent from the server to the client to register a new capability
	* handler on the client side.
	*/
	var RegistrationRequest;
	(function(RegistrationRequest) {
		RegistrationRequest.method = "client/registerCapability";
		RegistrationRequest.messageDirection = messages_1.MessageDirection.serverToClient;
		RegistrationRequest.type = new messages_1.ProtocolRequestType(RegistrationRequest.method);
	})(RegistrationRequest || (exports.RegistrationRequest = RegistrationRequest = {}));
	/**
	* The `client/unregisterCapability` request is sent from the server to the client to unregister a previously registered capability
	* handler on the client side.
	*/
	var UnregistrationRequest;
	(function(UnregistrationRequest) {
		UnregistrationRequest.method = "client/unregisterCapability";
		UnregistrationRequest.messageDirection = messages_1.MessageDirection.serverToClient;
		UnregistrationRequest.type = new messages_1.ProtocolRequestType(UnregistrationRequest.method);
	})(UnregistrationRequest || (exports.UnregistrationRequest = UnregistrationRequest = {}));
	var ResourceOperationKind;
	(function(ResourceOperationKind) {
		/**
		* Supports creating new files and folders.
		*/
		ResourceOperationKind.Create = "create";
		/**
		* Supports renaming existing files and folders.
		*/
		ResourceOperationKind.Rename = "rename";
		/**
		* Supports deleting existing files and folders.
		*/
		ResourceOperationKind.Delete = "delete";
	})(ResourceOperationKind || (exports.ResourceOperationKind = ResourceOperationKind = {}));
	var FailureHandlingKind;
	(function(FailureHandlingKind) {
		/**
		* Applying the workspace change is simply aborted if one of the changes provided
		* fails. All operations executed before the failing operation stay executed.
		*/
		FailureHandlingKind.Abort = "abort";
		/**
		* All operations are executed transactional. That means they either all
		* succeed or no changes at all are applied to the workspace.
		*/
		FailureHandlingKind.Transactional = "transactional";
		/**
		* If the workspace edit contains only textual file changes they are executed transactional.
		* If resource changes (create, rename or delete file) are part of the change the failure
		* handling strategy is abort.
		*/
		FailureHandlingKind.TextOnlyTransactional = "textOnlyTransactional";
		/**
		* The client tries to undo the operations already executed. But there is no
		* guarantee that this is succeeding.
		*/
		FailureHandlingKind.Undo = "undo";
	})(FailureHandlingKind || (exports.FailureHandlingKind = FailureHandlingKind = {}));
	/**
	* Regular Expression Engines
	*
	* @since 3.18.0
	*/
	var RegularExpressionEngineKind;
	(function(RegularExpressionEngineKind) {
		RegularExpressionEngineKind.ES2020 = "ES2020";
	})(RegularExpressionEngineKind || (exports.RegularExpressionEngineKind = RegularExpressionEngineKind = {}));
	/**
	* A set of predefined position encoding kinds.
	*
	* @since 3.17.0
	*/
	var PositionEncodingKind;
	(function(PositionEncodingKind) {
		/**
		* Character offsets count UTF-8 code units (e.g. bytes).
		*/
		PositionEncodingKind.UTF8 = "utf-8";
		/**
		* Character offsets count UTF-16 code units.
		*
		* This is the default and must always be supported
		* by servers
		*/
		PositionEncodingKind.UTF16 = "utf-16";
		/**
		* Character offsets count UTF-32 code units.
		*
		* Implementation note: these are the same as Unicode codepoints,
		* so this `PositionEncodingKind` may also be used for an
		* encoding-agnostic representation of character offsets.
		*/
		PositionEncodingKind.UTF32 = "utf-32";
	})(PositionEncodingKind || (exports.PositionEncodingKind = PositionEncodingKind = {}));
	/**
	* The StaticRegistrationOptions namespace provides helper functions to work with
	* {@link StaticRegistrationOptions} literals.
	*/
	var StaticRegistrationOptions;
	(function(StaticRegistrationOptions) {
		function hasId(value) {
			const candidate = value;
			return candidate && Is.string(candidate.id) && candidate.id.length > 0;
		}
		StaticRegistrationOptions.hasId = hasId;
	})(StaticRegistrationOptions || (exports.StaticRegistrationOptions = StaticRegistrationOptions = {}));
	/**
	* The TextDocumentRegistrationOptions namespace provides helper functions to work with
	* {@link TextDocumentRegistrationOptions} literals.
	*/
	var TextDocumentRegistrationOptions;
	(function(TextDocumentRegistrationOptions) {
		function is(value) {
			const candidate = value;
			return candidate && (candidate.documentSelector === null || DocumentSelector.is(candidate.documentSelector));
		}
		TextDocumentRegistrationOptions.is = is;
	})(TextDocumentRegistrationOptions || (exports.TextDocumentRegistrationOptions = TextDocumentRegistrationOptions = {}));
	/**
	* The WorkDoneProgressOptions namespace provides helper functions to work with
	* {@link WorkDoneProgressOptions} literals.
	*/
	var WorkDoneProgressOptions;
	(function(WorkDoneProgressOptions) {
		function is(value) {
			const candidate = value;
			return Is.objectLiteral(candidate) && (candidate.workDoneProgress === void 0 || Is.boolean(candidate.workDoneProgress));
		}
		WorkDoneProgressOptions.is = is;
		function hasWorkDoneProgress(value) {
			const candidate = value;
			return candidate && Is.boolean(candidate.workDoneProgress);
		}
		WorkDoneProgressOptions.hasWorkDoneProgress = hasWorkDoneProgress;
	})(WorkDoneProgressOptions || (exports.WorkDoneProgressOptions = WorkDoneProgressOptions = {}));
	/**
	* The initialize request is sent from the client to the server.
	* It is sent once as the request after starting up the server.
	* The requests parameter is of type {@link InitializeParams}
	* the response if of type {@link InitializeResult} of a Thenable that
	* resolves to such.
	*/
	var InitializeRequest;
	(function(InitializeRequest) {
		InitializeRequest.method = "initialize";
		InitializeRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		InitializeRequest.type = new messages_1.ProtocolRequestType(InitializeRequest.method);
	})(InitializeRequest || (exports.InitializeRequest = InitializeRequest = {}));
	/**
	* Known error codes for an `InitializeErrorCodes`;
	*/
	var InitializeErrorCodes;
	(function(InitializeErrorCodes) {
		/**
		* If the protocol version provided by the client can't be handled by the server.
		*
		* @deprecated This initialize error got replaced by client capabilities. There is
		* no version handshake in version 3.0x
		*/
		InitializeErrorCodes.unknownProtocolVersion = 1;
	})(InitializeErrorCodes || (exports.InitializeErrorCodes = InitializeErrorCodes = {}));
	/**
	* The initialized notification is sent from the client to the
	* server after the client is fully initialized and the server
	* is allowed to send requests from the server to the client.
	*/
	var InitializedNotification;
	(function(InitializedNotification) {
		InitializedNotification.method = "initialized";
		InitializedNotification.messageDirection = messages_1.MessageDirection.clientToServer;
		InitializedNotification.type = new messages_1.ProtocolNotificationType(InitializedNotification.method);
	})(InitializedNotification || (exports.InitializedNotification = InitializedNotification = {}));
	/**
	* A shutdown request is sent from the client to the server.
	* It is sent once when the client decides to shutdown the
	* server. The only notification that is sent after a shutdown request
	* is the exit event.
	*/
	var ShutdownRequest;
	(function(ShutdownRequest) {
		ShutdownRequest.method = "shutdown";
		ShutdownRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		ShutdownRequest.type = new messages_1.ProtocolRequestType0(ShutdownRequest.method);
	})(ShutdownRequest || (exports.ShutdownRequest = ShutdownRequest = {}));
	/**
	* The exit event is sent from the client to the server to
	* ask the server to exit its process.
	*/
	var ExitNotification;
	(function(ExitNotification) {
		ExitNotification.method = "exit";
		ExitNotification.messageDirection = messages_1.MessageDirection.clientToServer;
		ExitNotification.type = new messages_1.ProtocolNotificationType0(ExitNotification.method);
	})(ExitNotification || (exports.ExitNotification = ExitNotification = {}));
	/**
	* The configuration change notification is sent from the client to the server
	* when the client's configuration has changed. The notification contains
	* the changed configuration as defined by the language client.
	*/
	var DidChangeConfigurationNotification;
	(function(DidChangeConfigurationNotification) {
		DidChangeConfigurationNotification.method = "workspace/didChangeConfiguration";
		DidChangeConfigurationNotification.messageDirection = messages_1.MessageDirection.clientToServer;
		DidChangeConfigurationNotification.type = new messages_1.ProtocolNotificationType(DidChangeConfigurationNotification.method);
		DidChangeConfigurationNotification.capabilities = messages_1.CM.create("workspace.didChangeConfiguration", void 0);
	})(DidChangeConfigurationNotification || (exports.DidChangeConfigurationNotification = DidChangeConfigurationNotification = {}));
	/**
	* The message type
	*/
	var MessageType;
	(function(MessageType) {
		/**
		* An error message.
		*/
		MessageType.Error = 1;
		/**
		* A warning message.
		*/
		MessageType.Warning = 2;
		/**
		* An information message.
		*/
		MessageType.Info = 3;
		/**
		* A log message.
		*/
		MessageType.Log = 4;
		/**
		* A debug message.
		*
		* @since 3.18.0
		*/
		MessageType.Debug = 5;
	})(MessageType || (exports.MessageType = MessageType = {}));
	/**
	* The show message notification is sent from a server to a client to ask
	* the client to display a particular message in the user interface.
	*/
	var ShowMessageNotification;
	(function(ShowMessageNotification) {
		ShowMessageNotification.method = "window/showMessage";
		ShowMessageNotification.messageDirection = messages_1.MessageDirection.serverToClient;
		ShowMessageNotification.type = new messages_1.ProtocolNotificationType(ShowMessageNotification.method);
		ShowMessageNotification.capabilities = messages_1.CM.create("window.showMessage", void 0);
	})(ShowMessageNotification || (exports.ShowMessageNotification = ShowMessageNotification = {}));
	/**
	* The show message request is sent from the server to the client to show a message
	* and a set of options actions to the user.
	*/
	var ShowMessageRequest;
	(function(ShowMessageRequest) {
		ShowMessageRequest.method = "window/showMessageRequest";
		ShowMessageRequest.messageDirection = messages_1.MessageDirection.serverToClient;
		ShowMessageRequest.type = new messages_1.ProtocolRequestType(ShowMessageRequest.method);
		ShowMessageRequest.capabilities = messages_1.CM.create("window.showMessage", void 0);
	})(ShowMessageRequest || (exports.ShowMessageRequest = ShowMessageRequest = {}));
	/**
	* The log message notification is sent from the server to the client to ask
	* the client to log a particular message.
	*/
	var LogMessageNotification;
	(function(LogMessageNotification) {
		LogMessageNotification.method = "window/logMessage";
		LogMessageNotification.messageDirection = messages_1.MessageDirection.serverToClient;
		LogMessageNotification.type = new messages_1.ProtocolNotificationType(LogMessageNotification.method);
	})(LogMessageNotification || (exports.LogMessageNotification = LogMessageNotification = {}));
	/**
	* The telemetry event notification is sent from the server to the client to ask
	* the client to log telemetry data.
	*/
	var TelemetryEventNotification;
	(function(TelemetryEventNotification) {
		TelemetryEventNotification.method = "telemetry/event";
		TelemetryEventNotification.messageDirection = messages_1.MessageDirection.serverToClient;
		TelemetryEventNotification.type = new messages_1.ProtocolNotificationType(TelemetryEventNotification.method);
	})(TelemetryEventNotification || (exports.TelemetryEventNotification = TelemetryEventNotification = {}));
	/**
	* Defines how the host (editor) should sync
	* document changes to the language server.
	*/
	var TextDocumentSyncKind;
	(function(TextDocumentSyncKind) {
		/**
		* Documents should not be synced at all.
		*/
		TextDocumentSyncKind.None = 0;
		/**
		* Documents are synced by always sending the full content
		* of the document.
		*/
		TextDocumentSyncKind.Full = 1;
		/**
		* Documents are synced by sending the full content on open.
		* After that only incremental updates to the document are
		* send.
		*/
		TextDocumentSyncKind.Incremental = 2;
	})(TextDocumentSyncKind || (exports.TextDocumentSyncKind = TextDocumentSyncKind = {}));
	/**
	* The document open notification is sent from the client to the server to signal
	* newly opened text documents. The document's truth is now managed by the client
	* and the server must not try to read the document's truth using the document's
	* uri. Open in this sense means it is managed by the client. It doesn't necessarily
	* mean that its content is presented in an editor. An open notification must not
	* be sent more than once without a corresponding close notification send before.
	* This means open and close notification must be balanced and the max open count
	* is one.
	*/
	var DidOpenTextDocumentNotification;
	(function(DidOpenTextDocumentNotification) {
		DidOpenTextDocumentNotification.method = "textDocument/didOpen";
		DidOpenTextDocumentNotification.messageDirection = messages_1.MessageDirection.clientToServer;
		DidOpenTextDocumentNotification.type = new messages_1.ProtocolNotificationType(DidOpenTextDocumentNotification.method);
		DidOpenTextDocumentNotification.capabilities = messages_1.CM.create("textDocument.synchronization", "textDocumentSync.openClose");
	})(DidOpenTextDocumentNotification || (exports.DidOpenTextDocumentNotification = DidOpenTextDocumentNotification = {}));
	var TextDocumentContentChangeEvent;
	(function(TextDocumentContentChangeEvent) {
		/**
		* Checks whether the information describes a delta event.
		*/
		function isIncremental(event) {
			const candidate = event;
			return candidate !== void 0 && candidate !== null && typeof candidate.text === "string" && candidate.range !== void 0 && (candidate.rangeLength === void 0 || typeof candidate.rangeLength === "number");
		}
		TextDocumentContentChangeEvent.isIncremental = isIncremental;
		/**
		* Checks whether the information describes a full replacement event.
		*/
		function isFull(event) {
			const candidate = event;
			return candidate !== void 0 && candidate !== null && typeof candidate.text === "string" && candidate.range === void 0 && candidate.rangeLength === void 0;
		}
		TextDocumentContentChangeEvent.isFull = isFull;
	})(TextDocumentContentChangeEvent || (exports.TextDocumentContentChangeEvent = TextDocumentContentChangeEvent = {}));
	/**
	* The document change notification is sent from the client to the server to signal
	* changes to a text document.
	*/
	var DidChangeTextDocumentNotification;
	(function(DidChangeTextDocumentNotification) {
		DidChangeTextDocumentNotification.method = "textDocument/didChange";
		DidChangeTextDocumentNotification.messageDirection = messages_1.MessageDirection.clientToServer;
		DidChangeTextDocumentNotification.type = new messages_1.ProtocolNotificationType(DidChangeTextDocumentNotification.method);
		DidChangeTextDocumentNotification.capabilities = messages_1.CM.create("textDocument.synchronization", "textDocumentSync");
	})(DidChangeTextDocumentNotification || (exports.DidChangeTextDocumentNotification = DidChangeTextDocumentNotification = {}));
	/**
	* The document close notification is sent from the client to the server when
	* the document got closed in the client. The document's truth now exists where
	* the document's uri points to (e.g. if the document's uri is a file uri the
	* truth now exists on disk). As with the open notification the close notification
	* is about managing the document's content. Receiving a close notification
	* doesn't mean that the document was open in an editor before. A close
	* notification requires a previous open notification to be sent.
	*/
	var DidCloseTextDocumentNotification;
	(function(DidCloseTextDocumentNotification) {
		DidCloseTextDocumentNotification.method = "textDocument/didClose";
		DidCloseTextDocumentNotification.messageDirection = messages_1.MessageDirection.clientToServer;
		DidCloseTextDocumentNotification.type = new messages_1.ProtocolNotificationType(DidCloseTextDocumentNotification.method);
		DidCloseTextDocumentNotification.capabilities = messages_1.CM.create("textDocument.synchronization", "textDocumentSync.openClose");
	})(DidCloseTextDocumentNotification || (exports.DidCloseTextDocumentNotification = DidCloseTextDocumentNotification = {}));
	/**
	* The document save notification is sent from the client to the server when
	* the document got saved in the client.
	*/
	var DidSaveTextDocumentNotification;
	(function(DidSaveTextDocumentNotification) {
		DidSaveTextDocumentNotification.method = "textDocument/didSave";
		DidSaveTextDocumentNotification.messageDirection = messages_1.MessageDirection.clientToServer;
		DidSaveTextDocumentNotification.type = new messages_1.ProtocolNotificationType(DidSaveTextDocumentNotification.method);
		DidSaveTextDocumentNotification.capabilities = messages_1.CM.create("textDocument.synchronization.didSave", "textDocumentSync.save");
	})(DidSaveTextDocumentNotification || (exports.DidSaveTextDocumentNotification = DidSaveTextDocumentNotification = {}));
	/**
	* Represents reasons why a text document is saved.
	*/
	var TextDocumentSaveReason;
	(function(TextDocumentSaveReason) {
		/**
		* Manually triggered, e.g. by the user pressing save, by starting debugging,
		* or by an API call.
		*/
		TextDocumentSaveReason.Manual = 1;
		/**
		* Automatic after a delay.
		*/
		TextDocumentSaveReason.AfterDelay = 2;
		/**
		* When the editor lost focus.
		*/
		TextDocumentSaveReason.FocusOut = 3;
	})(TextDocumentSaveReason || (exports.TextDocumentSaveReason = TextDocumentSaveReason = {}));
	/**
	* A document will save notification is sent from the client to the server before
	* the document is actually saved.
	*/
	var WillSaveTextDocumentNotification;
	(function(WillSaveTextDocumentNotification) {
		WillSaveTextDocumentNotification.method = "textDocument/willSave";
		WillSaveTextDocumentNotification.messageDirection = messages_1.MessageDirection.clientToServer;
		WillSaveTextDocumentNotification.type = new messages_1.ProtocolNotificationType(WillSaveTextDocumentNotification.method);
		WillSaveTextDocumentNotification.capabilities = messages_1.CM.create("textDocument.synchronization.willSave", "textDocumentSync.willSave");
	})(WillSaveTextDocumentNotification || (exports.WillSaveTextDocumentNotification = WillSaveTextDocumentNotification = {}));
	/**
	* A document will save request is sent from the client to the server before
	* the document is actually saved. The request can return an array of TextEdits
	* which will be applied to the text document before it is saved. Please note that
	* clients might drop results if computing the text edits took too long or if a
	* server constantly fails on this request. This is done to keep the save fast and
	* reliable.
	*/
	var WillSaveTextDocumentWaitUntilRequest;
	(function(WillSaveTextDocumentWaitUntilRequest) {
		WillSaveTextDocumentWaitUntilRequest.method = "textDocument/willSaveWaitUntil";
		WillSaveTextDocumentWaitUntilRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		WillSaveTextDocumentWaitUntilRequest.type = new messages_1.ProtocolRequestType(WillSaveTextDocumentWaitUntilRequest.method);
		WillSaveTextDocumentWaitUntilRequest.capabilities = messages_1.CM.create("textDocument.synchronization.willSaveWaitUntil", "textDocumentSync.willSaveWaitUntil");
	})(WillSaveTextDocumentWaitUntilRequest || (exports.WillSaveTextDocumentWaitUntilRequest = WillSaveTextDocumentWaitUntilRequest = {}));
	/**
	* The watched files notification is sent from the client to the server when
	* the client detects changes to file watched by the language client.
	*/
	var DidChangeWatchedFilesNotification;
	(function(DidChangeWatchedFilesNotification) {
		DidChangeWatchedFilesNotification.method = "workspace/didChangeWatchedFiles";
		DidChangeWatchedFilesNotification.messageDirection = messages_1.MessageDirection.clientToServer;
		DidChangeWatchedFilesNotification.type = new messages_1.ProtocolNotificationType(DidChangeWatchedFilesNotification.method);
		DidChangeWatchedFilesNotification.capabilities = messages_1.CM.create("workspace.didChangeWatchedFiles", void 0);
	})(DidChangeWatchedFilesNotification || (exports.DidChangeWatchedFilesNotification = DidChangeWatchedFilesNotification = {}));
	/**
	* The file event type
	*/
	var FileChangeType;
	(function(FileChangeType) {
		/**
		* The file got created.
		*/
		FileChangeType.Created = 1;
		/**
		* The file got changed.
		*/
		FileChangeType.Changed = 2;
		/**
		* The file got deleted.
		*/
		FileChangeType.Deleted = 3;
	})(FileChangeType || (exports.FileChangeType = FileChangeType = {}));
	var RelativePattern;
	(function(RelativePattern) {
		function is(value) {
			const candidate = value;
			return Is.objectLiteral(candidate) && (vscode_languageserver_types_1.URI.is(candidate.baseUri) || vscode_languageserver_types_1.WorkspaceFolder.is(candidate.baseUri)) && Is.string(candidate.pattern);
		}
		RelativePattern.is = is;
	})(RelativePattern || (exports.RelativePattern = RelativePattern = {}));
	var GlobPattern;
	(function(GlobPattern) {
		function is(value) {
			const candidate = value;
			return Is.string(candidate) || RelativePattern.is(candidate);
		}
		GlobPattern.is = is;
	})(GlobPattern || (exports.GlobPattern = GlobPattern = {}));
	var WatchKind;
	(function(WatchKind) {
		/**
		* Interested in create events.
		*/
		WatchKind.Create = 1;
		/**
		* Interested in change events
		*/
		WatchKind.Change = 2;
		/**
		* Interested in delete events
		*/
		WatchKind.Delete = 4;
	})(WatchKind || (exports.WatchKind = WatchKind = {}));
	/**
	* Diagnostics notification are sent from the server to the client to signal
	* results of validation runs.
	*/
	var PublishDiagnosticsNotification;
	(function(PublishDiagnosticsNotification) {
		PublishDiagnosticsNotification.method = "textDocument/publishDiagnostics";
		PublishDiagnosticsNotification.messageDirection = messages_1.MessageDirection.serverToClient;
		PublishDiagnosticsNotification.type = new messages_1.ProtocolNotificationType(PublishDiagnosticsNotification.method);
		PublishDiagnosticsNotification.capabilities = messages_1.CM.create("textDocument.publishDiagnostics", void 0);
	})(PublishDiagnosticsNotification || (exports.PublishDiagnosticsNotification = PublishDiagnosticsNotification = {}));
	/**
	* How a completion was triggered
	*/
	var CompletionTriggerKind;
	(function(CompletionTriggerKind) {
		/**
		* Completion was triggered by typing an identifier (24x7 code
		* complete), manual invocation (e.g Ctrl+Space) or via API.
		*/
		CompletionTriggerKind.Invoked = 1;
		/**
		* Completion was triggered by a trigger character specified by
		* the `triggerCharacters` properties of the `CompletionRegistrationOptions`.
		*/
		CompletionTriggerKind.TriggerCharacter = 2;
		/**
		* Completion was re-triggered as current completion list is incomplete
		*/
		CompletionTriggerKind.TriggerForIncompleteCompletions = 3;
	})(CompletionTriggerKind || (exports.CompletionTriggerKind = CompletionTriggerKind = {}));
	/**
	* Request to request completion at a given text document position. The request's
	* parameter is of type {@link TextDocumentPosition} the response
	* is of type {@link CompletionItem CompletionItem[]} or {@link CompletionList}
	* or a Thenable that resolves to such.
	*
	* The request can delay the computation of the {@link CompletionItem.detail `detail`}
	* and {@link CompletionItem.documentation `documentation`} properties to the `completionItem/resolve`
	* request. However, properties that are needed for the initial sorting and filtering, like `sortText`,
	* `filterText`, `insertText`, and `textEdit`, must not be changed during resolve.
	*/
	var CompletionRequest;
	(function(CompletionRequest) {
		CompletionRequest.method = "textDocument/completion";
		CompletionRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		CompletionRequest.type = new messages_1.ProtocolRequestType(CompletionRequest.method);
		CompletionRequest.capabilities = messages_1.CM.create("textDocument.completion", "completionProvider");
	})(CompletionRequest || (exports.CompletionRequest = CompletionRequest = {}));
	/**
	* Request to resolve additional information for a given completion item.The request's
	* parameter is of type {@link CompletionItem} the response
	* is of type {@link CompletionItem} or a Thenable that resolves to such.
	*/
	var CompletionResolveRequest;
	(function(CompletionResolveRequest) {
		CompletionResolveRequest.method = "completionItem/resolve";
		CompletionResolveRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		CompletionResolveRequest.type = new messages_1.ProtocolRequestType(CompletionResolveRequest.method);
		CompletionResolveRequest.capabilities = messages_1.CM.create("textDocument.completion.completionItem.resolveSupport", "completionProvider.resolveProvider");
	})(CompletionResolveRequest || (exports.CompletionResolveRequest = CompletionResolveRequest = {}));
	/**
	* Request to request hover information at a given text document position. The request's
	* parameter is of type {@link TextDocumentPosition} the response is of
	* type {@link Hover} or a Thenable that resolves to such.
	*/
	var HoverRequest;
	(function(HoverRequest) {
		HoverRequest.method = "textDocument/hover";
		HoverRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		HoverRequest.type = new messages_1.ProtocolRequestType(HoverRequest.method);
		HoverRequest.capabilities = messages_1.CM.create("textDocument.hover", "hoverProvider");
	})(HoverRequest || (exports.HoverRequest = HoverRequest = {}));
	/**
	* How a signature help was triggered.
	*
	* @since 3.15.0
	*/
	var SignatureHelpTriggerKind;
	(function(SignatureHelpTriggerKind) {
		/**
		* Signature help was invoked manually by the user or by a command.
		*/
		SignatureHelpTriggerKind.Invoked = 1;
		/**
		* Signature help was triggered by a trigger character.
		*/
		SignatureHelpTriggerKind.TriggerCharacter = 2;
		/**
		* Signature help was triggered by the cursor moving or by the document content changing.
		*/
		SignatureHelpTriggerKind.ContentChange = 3;
	})(SignatureHelpTriggerKind || (exports.SignatureHelpTriggerKind = SignatureHelpTriggerKind = {}));
	var SignatureHelpRequest;
	(function(SignatureHelpRequest) {
		SignatureHelpRequest.method = "textDocument/signatureHelp";
		SignatureHelpRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		SignatureHelpRequest.type = new messages_1.ProtocolRequestType(SignatureHelpRequest.method);
		SignatureHelpRequest.capabilities = messages_1.CM.create("textDocument.signatureHelp", "signatureHelpProvider");
	})(SignatureHelpRequest || (exports.SignatureHelpRequest = SignatureHelpRequest = {}));
	/**
	* A request to resolve the definition location of a symbol at a given text
	* document position. The request's parameter is of type {@link TextDocumentPosition}
	* the response is of either type {@link Definition} or a typed array of
	* {@link DefinitionLink} or a Thenable that resolves to such.
	*/
	var DefinitionRequest;
	(function(DefinitionRequest) {
		DefinitionRequest.method = "textDocument/definition";
		DefinitionRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		DefinitionRequest.type = new messages_1.ProtocolRequestType(DefinitionRequest.method);
		DefinitionRequest.capabilities = messages_1.CM.create("textDocument.definition", "definitionProvider");
	})(DefinitionRequest || (exports.DefinitionRequest = DefinitionRequest = {}));
	/**
	* A request to resolve project-wide references for the symbol denoted
	* by the given text document position. The request's parameter is of
	* type {@link ReferenceParams} the response is of type
	* {@link Location Location[]} or a Thenable that resolves to such.
	*/
	var ReferencesRequest;
	(function(ReferencesRequest) {
		ReferencesRequest.method = "textDocument/references";
		ReferencesRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		ReferencesRequest.type = new messages_1.ProtocolRequestType(ReferencesRequest.method);
		ReferencesRequest.capabilities = messages_1.CM.create("textDocument.references", "referencesProvider");
	})(ReferencesRequest || (exports.ReferencesRequest = ReferencesRequest = {}));
	/**
	* Request to resolve a {@link DocumentHighlight} for a given
	* text document position. The request's parameter is of type {@link TextDocumentPosition}
	* the request response is an array of type {@link DocumentHighlight}
	* or a Thenable that resolves to such.
	*/
	var DocumentHighlightRequest;
	(function(DocumentHighlightRequest) {
		DocumentHighlightRequest.method = "textDocument/documentHighlight";
		DocumentHighlightRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		DocumentHighlightRequest.type = new messages_1.ProtocolRequestType(DocumentHighlightRequest.method);
		DocumentHighlightRequest.capabilities = messages_1.CM.create("textDocument.documentHighlight", "documentHighlightProvider");
	})(DocumentHighlightRequest || (exports.DocumentHighlightRequest = DocumentHighlightRequest = {}));
	/**
	* A request to list all symbols found in a given text document. The request's
	* parameter is of type {@link TextDocumentIdentifier} the
	* response is of type {@link SymbolInformation SymbolInformation[]} or a Thenable
	* that resolves to such.
	*/
	var DocumentSymbolRequest;
	(function(DocumentSymbolRequest) {
		DocumentSymbolRequest.method = "textDocument/documentSymbol";
		DocumentSymbolRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		DocumentSymbolRequest.type = new messages_1.ProtocolRequestType(DocumentSymbolRequest.method);
		DocumentSymbolRequest.capabilities = messages_1.CM.create("textDocument.documentSymbol", "documentSymbolProvider");
	})(DocumentSymbolRequest || (exports.DocumentSymbolRequest = DocumentSymbolRequest = {}));
	/**
	* A request to provide commands for the given text document and range.
	*/
	var CodeActionRequest;
	(function(CodeActionRequest) {
		CodeActionRequest.method = "textDocument/codeAction";
		CodeActionRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		CodeActionRequest.type = new messages_1.ProtocolRequestType(CodeActionRequest.method);
		CodeActionRequest.capabilities = messages_1.CM.create("textDocument.codeAction", "codeActionProvider");
	})(CodeActionRequest || (exports.CodeActionRequest = CodeActionRequest = {}));
	/**
	* Request to resolve additional information for a given code action.The request's
	* parameter is of type {@link CodeAction} the response
	* is of type {@link CodeAction} or a Thenable that resolves to such.
	*/
	var CodeActionResolveRequest;
	(function(CodeActionResolveRequest) {
		CodeActionResolveRequest.method = "codeAction/resolve";
		CodeActionResolveRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		CodeActionResolveRequest.type = new messages_1.ProtocolRequestType(CodeActionResolveRequest.method);
		CodeActionResolveRequest.capabilities = messages_1.CM.create("textDocument.codeAction.resolveSupport", "codeActionProvider.resolveProvider");
	})(CodeActionResolveRequest || (exports.CodeActionResolveRequest = CodeActionResolveRequest = {}));
	/**
	* A request to list project-wide symbols matching the query string given
	* by the {@link WorkspaceSymbolParams}. The response is
	* of type {@link SymbolInformation SymbolInformation[]} or a Thenable that
	* resolves to such.
	*
	* @since 3.17.0 - support for WorkspaceSymbol in the returned data. Clients
	*  need to advertise support for WorkspaceSymbols via the client capability
	*  `workspace.symbol.resolveSupport`.
	*
	*/
	var WorkspaceSymbolRequest;
	(function(WorkspaceSymbolRequest) {
		WorkspaceSymbolRequest.method = "workspace/symbol";
		WorkspaceSymbolRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		WorkspaceSymbolRequest.type = new messages_1.ProtocolRequestType(WorkspaceSymbolRequest.method);
		WorkspaceSymbolRequest.capabilities = messages_1.CM.create("workspace.symbol", "workspaceSymbolProvider");
	})(WorkspaceSymbolRequest || (exports.WorkspaceSymbolRequest = WorkspaceSymbolRequest = {}));
	/**
	* A request to resolve the range inside the workspace
	* symbol's location.
	*
	* @since 3.17.0
	*/
	var WorkspaceSymbolResolveRequest;
	(function(WorkspaceSymbolResolveRequest) {
		WorkspaceSymbolResolveRequest.method = "workspaceSymbol/resolve";
		WorkspaceSymbolResolveRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		WorkspaceSymbolResolveRequest.type = new messages_1.ProtocolRequestType(WorkspaceSymbolResolveRequest.method);
		WorkspaceSymbolResolveRequest.capabilities = messages_1.CM.create("workspace.symbol.resolveSupport", "workspaceSymbolProvider.resolveProvider");
	})(WorkspaceSymbolResolveRequest || (exports.WorkspaceSymbolResolveRequest = WorkspaceSymbolResolveRequest = {}));
	/**
	* A request to provide code lens for the given text document.
	*/
	var CodeLensRequest;
	(function(CodeLensRequest) {
		CodeLensRequest.method = "textDocument/codeLens";
		CodeLensRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		CodeLensRequest.type = new messages_1.ProtocolRequestType(CodeLensRequest.method);
		CodeLensRequest.capabilities = messages_1.CM.create("textDocument.codeLens", "codeLensProvider");
	})(CodeLensRequest || (exports.CodeLensRequest = CodeLensRequest = {}));
	/**
	* A request to resolve a command for a given code lens.
	*/
	var CodeLensResolveRequest;
	(function(CodeLensResolveRequest) {
		CodeLensResolveRequest.method = "codeLens/resolve";
		CodeLensResolveRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		CodeLensResolveRequest.type = new messages_1.ProtocolRequestType(CodeLensResolveRequest.method);
		CodeLensResolveRequest.capabilities = messages_1.CM.create("textDocument.codeLens.resolveSupport", "codeLensProvider.resolveProvider");
	})(CodeLensResolveRequest || (exports.CodeLensResolveRequest = CodeLensResolveRequest = {}));
	/**
	* A request to refresh all code actions
	*
	* @since 3.16.0
	*/
	var CodeLensRefreshRequest;
	(function(CodeLensRefreshRequest) {
		CodeLensRefreshRequest.method = `workspace/codeLens/refresh`;
		CodeLensRefreshRequest.messageDirection = messages_1.MessageDirection.serverToClient;
		CodeLensRefreshRequest.type = new messages_1.ProtocolRequestType0(CodeLensRefreshRequest.method);
		CodeLensRefreshRequest.capabilities = messages_1.CM.create("workspace.codeLens", void 0);
	})(CodeLensRefreshRequest || (exports.CodeLensRefreshRequest = CodeLensRefreshRequest = {}));
	/**
	* A request to provide document links
	*/
	var DocumentLinkRequest;
	(function(DocumentLinkRequest) {
		DocumentLinkRequest.method = "textDocument/documentLink";
		DocumentLinkRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		DocumentLinkRequest.type = new messages_1.ProtocolRequestType(DocumentLinkRequest.method);
		DocumentLinkRequest.capabilities = messages_1.CM.create("textDocument.documentLink", "documentLinkProvider");
	})(DocumentLinkRequest || (exports.DocumentLinkRequest = DocumentLinkRequest = {}));
	/**
	* Request to resolve additional information for a given document link. The request's
	* parameter is of type {@link DocumentLink} the response
	* is of type {@link DocumentLink} or a Thenable that resolves to such.
	*/
	var DocumentLinkResolveRequest;
	(function(DocumentLinkResolveRequest) {
		DocumentLinkResolveRequest.method = "documentLink/resolve";
		DocumentLinkResolveRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		DocumentLinkResolveRequest.type = new messages_1.ProtocolRequestType(DocumentLinkResolveRequest.method);
		DocumentLinkResolveRequest.capabilities = messages_1.CM.create("textDocument.documentLink", "documentLinkProvider.resolveProvider");
	})(DocumentLinkResolveRequest || (exports.DocumentLinkResolveRequest = DocumentLinkResolveRequest = {}));
	/**
	* A request to format a whole document.
	*/
	var DocumentFormattingRequest;
	(function(DocumentFormattingRequest) {
		DocumentFormattingRequest.method = "textDocument/formatting";
		DocumentFormattingRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		DocumentFormattingRequest.type = new messages_1.ProtocolRequestType(DocumentFormattingRequest.method);
		DocumentFormattingRequest.capabilities = messages_1.CM.create("textDocument.formatting", "documentFormattingProvider");
	})(DocumentFormattingRequest || (exports.DocumentFormattingRequest = DocumentFormattingRequest = {}));
	/**
	* A request to format a range in a document.
	*/
	var DocumentRangeFormattingRequest;
	(function(DocumentRangeFormattingRequest) {
		DocumentRangeFormattingRequest.method = "textDocument/rangeFormatting";
		DocumentRangeFormattingRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		DocumentRangeFormattingRequest.type = new messages_1.ProtocolRequestType(DocumentRangeFormattingRequest.method);
		DocumentRangeFormattingRequest.capabilities = messages_1.CM.create("textDocument.rangeFormatting", "documentRangeFormattingProvider");
	})(DocumentRangeFormattingRequest || (exports.DocumentRangeFormattingRequest = DocumentRangeFormattingRequest = {}));
	/**
	* A request to format ranges in a document.
	*
	* @since 3.18.0
	*/
	var DocumentRangesFormattingRequest;
	(function(DocumentRangesFormattingRequest) {
		DocumentRangesFormattingRequest.method = "textDocument/rangesFormatting";
		DocumentRangesFormattingRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		DocumentRangesFormattingRequest.type = new messages_1.ProtocolRequestType(DocumentRangesFormattingRequest.method);
		DocumentRangesFormattingRequest.capabilities = messages_1.CM.create("textDocument.rangeFormatting.rangesSupport", "documentRangeFormattingProvider.rangesSupport");
	})(DocumentRangesFormattingRequest || (exports.DocumentRangesFormattingRequest = DocumentRangesFormattingRequest = {}));
	/**
	* A request to format a document on type.
	*/
	var DocumentOnTypeFormattingRequest;
	(function(DocumentOnTypeFormattingRequest) {
		DocumentOnTypeFormattingRequest.method = "textDocument/onTypeFormatting";
		DocumentOnTypeFormattingRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		DocumentOnTypeFormattingRequest.type = new messages_1.ProtocolRequestType(DocumentOnTypeFormattingRequest.method);
		DocumentOnTypeFormattingRequest.capabilities = messages_1.CM.create("textDocument.onTypeFormatting", "documentOnTypeFormattingProvider");
	})(DocumentOnTypeFormattingRequest || (exports.DocumentOnTypeFormattingRequest = DocumentOnTypeFormattingRequest = {}));
	var PrepareSupportDefaultBehavior;
	(function(PrepareSupportDefaultBehavior) {
		/**
		* The client's default behavior is to select the identifier
		* according the to language's syntax rule.
		*/
		PrepareSupportDefaultBehavior.Identifier = 1;
	})(PrepareSupportDefaultBehavior || (exports.PrepareSupportDefaultBehavior = PrepareSupportDefaultBehavior = {}));
	/**
	* A request to rename a symbol.
	*/
	var RenameRequest;
	(function(RenameRequest) {
		RenameRequest.method = "textDocument/rename";
		RenameRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		RenameRequest.type = new messages_1.ProtocolRequestType(RenameRequest.method);
		RenameRequest.capabilities = messages_1.CM.create("textDocument.rename", "renameProvider");
	})(RenameRequest || (exports.RenameRequest = RenameRequest = {}));
	/**
	* A request to test and perform the setup necessary for a rename.
	*
	* @since 3.16 - support for default behavior
	*/
	var PrepareRenameRequest;
	(function(PrepareRenameRequest) {
		PrepareRenameRequest.method = "textDocument/prepareRename";
		PrepareRenameRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		PrepareRenameRequest.type = new messages_1.ProtocolRequestType(PrepareRenameRequest.method);
		PrepareRenameRequest.capabilities = messages_1.CM.create("textDocument.rename.prepareSupport", "renameProvider.prepareProvider");
	})(PrepareRenameRequest || (exports.PrepareRenameRequest = PrepareRenameRequest = {}));
	/**
	* A request send from the client to the server to execute a command. The request might return
	* a workspace edit which the client will apply to the workspace.
	*/
	var ExecuteCommandRequest;
	(function(ExecuteCommandRequest) {
		ExecuteCommandRequest.method = "workspace/executeCommand";
		ExecuteCommandRequest.messageDirection = messages_1.MessageDirection.clientToServer;
		ExecuteCommandRequest.type = new messages_1.ProtocolRequestType(ExecuteCommandRequest.method);
		ExecuteCommandRequest.capabilities = messages_1.CM.create("workspace.executeCommand", "executeCommandProvider");
	})(ExecuteCommandRequest || (exports.ExecuteCommandRequest = ExecuteCommandRequest = {}));
	/**
	* A request sent from the server to the client to modified certain resources.
	*/
	var ApplyWorkspaceEditRequest;
	(function(ApplyWorkspaceEditRequest) {
		ApplyWorkspaceEditRequest.method = "workspace/applyEdit";
		ApplyWorkspaceEditRequest.messageDirection = messages_1.MessageDirection.serverToClient;
		ApplyWorkspaceEditRequest.type = new messages_1.ProtocolRequestType("workspace/applyEdit");
		ApplyWorkspaceEditRequest.capabilities = messages_1.CM.create("workspace.applyEdit", void 0);
	})(ApplyWorkspaceEditRequest || (exports.ApplyWorkspaceEditRequest = ApplyWorkspaceEditRequest = {}));
}));
// node_modules/vscode-languageserver-protocol/lib/common/connection.js
var require_connection = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.createProtocolConnection = createProtocolConnection;
	var vscode_jsonrpc_1 = require_api$2();
	function createProtocolConnection(input, output, logger, options) {
		if (vscode_jsonrpc_1.ConnectionStrategy.is(options)) options = { connectionStrategy: options };
		return (0, vscode_jsonrpc_1.createMessageConnection)(input, output, logger, options);
	}
}));
// node_modules/vscode-languageserver-protocol/lib/common/api.js
var require_api$1 = /* @__PURE__ */ __commonJSMin(((exports, module, this$28) => {
	var __createBinding = this$28 && this$28.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __exportStar = this$28 && this$28.__exportStar || function(m, exports) {
		for (var p in m) if (p !== "default" && !Object.prototype.hasOwnProperty.call(exports, p)) __createBinding(exports, m, p);
	};
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.LSPErrorCodes = exports.createProtocolConnection = void 0;
	__exportStar(require_api$2(), exports);
	__exportStar((init_main$1(), __toCommonJS(main_exports$1)), exports);
	__exportStar(require_messages(), exports);
	__exportStar(require_protocol(), exports);
	var connection_1 = require_connection();
	Object.defineProperty(exports, "createProtocolConnection", {
		enumerable: true,
		get: function() {
			return connection_1.createProtocolConnection;
		}
	});
	var LSPErrorCodes;
	(function(LSPErrorCodes) {
		/**
		* This is the start range of LSP reserved error codes.
		* It doesn't denote a real error code.
		*
		* @since 3.16.0
		*/
		LSPErrorCodes.lspReservedErrorRangeStart = -32899;
		/**
		* A request failed but it was syntactically correct, e.g the
		* method name was known and the parameters were valid. The error
		* message should contain human readable information about why
		* the request failed.
		*
		* @since 3.17.0
		*/
		LSPErrorCodes.RequestFailed = -32803;
		/**
		* The server cancelled the request. This error code should
		* only be used for requests that explicitly support being
		* server cancellable.
		*
		* @since 3.17.0
		*/
		LSPErrorCodes.ServerCancelled = -32802;
		/**
		* The server detected that the content of a document got
		* modified outside normal conditions. A server should
		* NOT send this error code if it detects a content change
		* in it unprocessed messages. The result even computed
		* on an older state might still be useful for the client.
		*
		* If a client decides that a result is not of any use anymore
		* the client should cancel the request.
		*/
		LSPErrorCodes.ContentModified = -32801;
		/**
		* The client has canceled a request and a server has detected
		* the cancel.
		*/
		LSPErrorCodes.RequestCancelled = -32800;
		/**
		* This is the end range of LSP reserved error codes.
		* It doesn't denote a real error code.
		*
		* @since 3.16.0
		*/
		LSPErrorCodes.lspReservedErrorRangeEnd = -32800;
	})(LSPErrorCodes || (exports.LSPErrorCodes = LSPErrorCodes = {}));
}));
// node_modules/vscode-languageclient/lib/common/utils/async.js
var require_async = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.Semaphore = exports.Delayer = void 0;
	exports.setTestMode = setTestMode;
	exports.clearTestMode = clearTestMode;
	exports.map = map;
	exports.mapAsync = mapAsync;
	exports.forEach = forEach;
	var vscode_languageserver_protocol_1 = require_api$1();
	var Delayer = class {
		defaultDelay;
		timeout;
		completionPromise;
		onSuccess;
		task;
		constructor(defaultDelay) {
			this.defaultDelay = defaultDelay;
			this.timeout = void 0;
			this.completionPromise = void 0;
			this.onSuccess = void 0;
			this.task = void 0;
		}
		trigger(task, delay = this.defaultDelay) {
			this.task = task;
			if (delay >= 0) this.cancelTimeout();
			if (!this.completionPromise) this.completionPromise = new Promise((resolve) => {
				this.onSuccess = resolve;
			}).then(() => {
				this.completionPromise = void 0;
				this.onSuccess = void 0;
				const result = this.task();
				this.task = void 0;
				return result;
			});
			if (delay >= 0 || this.timeout === void 0) this.timeout = (0, vscode_languageserver_protocol_1.RAL)().timer.setTimeout(() => {
				this.timeout = void 0;
				this.onSuccess(void 0);
			}, delay >= 0 ? delay : this.defaultDelay);
			return this.completionPromise;
		}
		forceDelivery() {
			if (!this.completionPromise) return;
			this.cancelTimeout();
			const result = this.task();
			this.completionPromise = void 0;
			this.onSuccess = void 0;
			this.task = void 0;
			return result;
		}
		isTriggered() {
			return this.timeout !== void 0;
		}
		cancel() {
			this.cancelTimeout();
			this.completionPromise = void 0;
		}
		cancelTimeout() {
			if (this.timeout !== void 0) {
				this.timeout.dispose();
				this.timeout = void 0;
			}
		}
	};
	exports.Delayer = Delayer;
	var Semaphore = class {
		_capacity;
		_active;
		_waiting;
		constructor(capacity = 1) {
			if (capacity <= 0) throw new Error("Capacity must be greater than 0");
			this._capacity = capacity;
			this._active = 0;
			this._waiting = [];
		}
		lock(thunk) {
			return new Promise((resolve, reject) => {
				this._waiting.push({
					thunk,
					resolve,
					reject
				});
				this.runNext();
			});
		}
		get active() {
			return this._active;
		}
		runNext() {
			if (this._waiting.length === 0 || this._active === this._capacity) return;
			(0, vscode_languageserver_protocol_1.RAL)().timer.setImmediate(() => this.doRunNext());
		}
		doRunNext() {
			if (this._waiting.length === 0 || this._active === this._capacity) return;
			const next = this._waiting.shift();
			this._active++;
			if (this._active > this._capacity) throw new Error(`To many thunks active`);
			try {
				const result = next.thunk();
				if (result instanceof Promise) result.then((value) => {
					this._active--;
					next.resolve(value);
					this.runNext();
				}, (err) => {
					this._active--;
					next.reject(err);
					this.runNext();
				});
				else {
					this._active--;
					next.resolve(result);
					this.runNext();
				}
			} catch (err) {
				this._active--;
				next.reject(err);
				this.runNext();
			}
		}
	};
	exports.Semaphore = Semaphore;
	var $test = false;
	function setTestMode() {
		$test = true;
	}
	function clearTestMode() {
		$test = false;
	}
	var defaultYieldTimeout = 15;
	var Timer = class {
		yieldAfter;
		startTime;
		counter;
		total;
		counterInterval;
		constructor(yieldAfter = defaultYieldTimeout) {
			this.yieldAfter = $test === true ? Math.max(yieldAfter, 2) : Math.max(yieldAfter, defaultYieldTimeout);
			this.startTime = Date.now();
			this.counter = 0;
			this.total = 0;
			this.counterInterval = 1;
		}
		start() {
			this.counter = 0;
			this.total = 0;
			this.counterInterval = 1;
			this.startTime = Date.now();
		}
		shouldYield() {
			if (++this.counter >= this.counterInterval) {
				const timeTaken = Date.now() - this.startTime;
				const timeLeft = Math.max(0, this.yieldAfter - timeTaken);
				this.total += this.counter;
				this.counter = 0;
				if (timeTaken >= this.yieldAfter || timeLeft <= 1) {
					this.counterInterval = 1;
					this.total = 0;
					return true;
				} else switch (timeTaken) {
					case 0:
					case 1: this.counterInterval = this.total * 2;
				}
			}
			return false;
		}
	};
	async function map(items, func, token, options) {
		if (items.length === 0) return [];
		const result = new Array(items.length);
		const timer = new Timer(options?.yieldAfter);
		function convertBatch(start) {
			timer.start();
			for (let i = start; i < items.length; i++) {
				result[i] = func(items[i]);
				if (timer.shouldYield()) {
					options?.yieldCallback && options.yieldCallback();
					return i + 1;
				}
			}
			return -1;
		}
		let index = convertBatch(0);
		while (index !== -1) {
			if (token !== void 0 && token.isCancellationRequested) break;
			index = await new Promise((resolve) => {
				(0, vscode_languageserver_protocol_1.RAL)().timer.setImmediate(() => {
					if (token !== void 0 && token.isCancellationRequested) resolve(-1);
					else resolve(convertBatch(index));
				});
			});
		}
		return result;
	}
	async function mapAsync(items, func, token, options) {
		if (items.length === 0) return [];
		const result = new Array(items.length);
		const timer = new Timer(options?.yieldAfter);
		async function convertBatch(start) {
			timer.start();
			for (let i = start; i < items.length; i++) {
				result[i] = await func(items[i], token);
				if (timer.shouldYield()) {
					options?.yieldCallback && options.yieldCallback();
					return i + 1;
				}
			}
			return -1;
		}
		let index = await convertBatch(0);
		while (index !== -1) {
			if (token !== void 0 && token.isCancellationRequested) break;
			index = await new Promise((resolve) => {
				(0, vscode_languageserver_protocol_1.RAL)().timer.setImmediate(() => {
					if (token !== void 0 && token.isCancellationRequested) resolve(-1);
					else resolve(convertBatch(index));
				});
			});
		}
		return result;
	}
	async function forEach(items, func, token, options) {
		if (items.length === 0) return;
		const timer = new Timer(options?.yieldAfter);
		function runBatch(start) {
			timer.start();
			for (let i = start; i < items.length; i++) {
				func(items[i]);
				if (timer.shouldYield()) {
					options?.yieldCallback && options.yieldCallback();
					return i + 1;
				}
			}
			return -1;
		}
		let index = runBatch(0);
		while (index !== -1) {
			if (token !== void 0 && token.isCancellationRequested) break;
			index = await new Promise((resolve) => {
				(0, vscode_languageserver_protocol_1.RAL)().timer.setImmediate(() => {
					if (token !== void 0 && token.isCancellationRequested) resolve(-1);
					else resolve(runBatch(index));
				});
			});
		}
	}
}));
// node_modules/vscode-languageclient/lib/common/protocolCompletionItem.js
var require_protocolCompletionItem = /* @__PURE__ */ __commonJSMin(((exports, module, this$27) => {
	var __createBinding = this$27 && this$27.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$27 && this$27.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$27 && this$27.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	Object.defineProperty(exports, "__esModule", { value: true });
	var code = __importStar(require("vscode"));
	var ProtocolCompletionItem = class extends code.CompletionItem {
		data;
		fromEdit;
		documentationFormat;
		originalItemKind;
		deprecated;
		insertTextMode;
		constructor(label) {
			super(label);
		}
	};
	exports.default = ProtocolCompletionItem;
}));
// node_modules/vscode-languageclient/lib/common/protocolCodeLens.js
var require_protocolCodeLens = /* @__PURE__ */ __commonJSMin(((exports, module, this$26) => {
	var __createBinding = this$26 && this$26.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$26 && this$26.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$26 && this$26.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	Object.defineProperty(exports, "__esModule", { value: true });
	var code = __importStar(require("vscode"));
	var ProtocolCodeLens = class extends code.CodeLens {
		data;
		constructor(range) {
			super(range);
		}
	};
	exports.default = ProtocolCodeLens;
}));
// node_modules/vscode-languageclient/lib/common/protocolDocumentLink.js
var require_protocolDocumentLink = /* @__PURE__ */ __commonJSMin(((exports, module, this$25) => {
	var __createBinding = this$25 && this$25.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$25 && this$25.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$25 && this$25.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	Object.defineProperty(exports, "__esModule", { value: true });
	var code = __importStar(require("vscode"));
	var ProtocolDocumentLink = class extends code.DocumentLink {
		data;
		constructor(range, target) {
			super(range, target);
		}
	};
	exports.default = ProtocolDocumentLink;
}));
// node_modules/vscode-languageclient/lib/common/protocolCodeAction.js
var require_protocolCodeAction = /* @__PURE__ */ __commonJSMin(((exports, module, this$24) => {
	var __createBinding = this$24 && this$24.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$24 && this$24.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$24 && this$24.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	Object.defineProperty(exports, "__esModule", { value: true });
	var vscode = __importStar(require("vscode"));
	var ProtocolCodeAction = class extends vscode.CodeAction {
		data;
		constructor(title, data) {
			super(title);
			this.data = data;
		}
	};
	exports.default = ProtocolCodeAction;
}));
// node_modules/vscode-languageclient/lib/common/protocolDiagnostic.js
var require_protocolDiagnostic = /* @__PURE__ */ __commonJSMin(((exports, module, this$23) => {
	var __createBinding = this$23 && this$23.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$23 && this$23.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$23 && this$23.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.ProtocolDiagnostic = exports.DiagnosticCode = void 0;
	var vscode = __importStar(require("vscode"));
	var Is = __importStar(require_is$2());
	var DiagnosticCode;
	(function(DiagnosticCode) {
		function is(value) {
			const candidate = value;
			return candidate !== void 0 && candidate !== null && (Is.number(candidate.value) || Is.string(candidate.value)) && Is.string(candidate.target);
		}
		DiagnosticCode.is = is;
	})(DiagnosticCode || (exports.DiagnosticCode = DiagnosticCode = {}));
	var ProtocolDiagnostic = class extends vscode.Diagnostic {
		data;
		hasDiagnosticCode;
		constructor(range, message, severity, data) {
			super(range, message, severity);
			this.data = data;
			this.hasDiagnosticCode = false;
		}
	};
	exports.ProtocolDiagnostic = ProtocolDiagnostic;
}));
// node_modules/vscode-languageclient/lib/common/protocolCallHierarchyItem.js
var require_protocolCallHierarchyItem = /* @__PURE__ */ __commonJSMin(((exports, module, this$22) => {
	var __createBinding = this$22 && this$22.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$22 && this$22.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$22 && this$22.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	Object.defineProperty(exports, "__esModule", { value: true });
	var code = __importStar(require("vscode"));
	var ProtocolCallHierarchyItem = class extends code.CallHierarchyItem {
		data;
		constructor(kind, name, detail, uri, range, selectionRange, data) {
			super(kind, name, detail, uri, range, selectionRange);
			if (data !== void 0) this.data = data;
		}
	};
	exports.default = ProtocolCallHierarchyItem;
}));
// node_modules/vscode-languageclient/lib/common/protocolTypeHierarchyItem.js
var require_protocolTypeHierarchyItem = /* @__PURE__ */ __commonJSMin(((exports, module, this$21) => {
	var __createBinding = this$21 && this$21.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$21 && this$21.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$21 && this$21.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	Object.defineProperty(exports, "__esModule", { value: true });
	var code = __importStar(require("vscode"));
	var ProtocolTypeHierarchyItem = class extends code.TypeHierarchyItem {
		data;
		constructor(kind, name, detail, uri, range, selectionRange, data) {
			super(kind, name, detail, uri, range, selectionRange);
			if (data !== void 0) this.data = data;
		}
	};
	exports.default = ProtocolTypeHierarchyItem;
}));
// node_modules/vscode-languageclient/lib/common/protocolWorkspaceSymbol.js
var require_protocolWorkspaceSymbol = /* @__PURE__ */ __commonJSMin(((exports, module, this$20) => {
	var __createBinding = this$20 && this$20.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$20 && this$20.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$20 && this$20.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	Object.defineProperty(exports, "__esModule", { value: true });
	var code = __importStar(require("vscode"));
	var WorkspaceSymbol = class extends code.SymbolInformation {
		data;
		hasRange;
		constructor(name, kind, containerName, locationOrUri, data) {
			const hasRange = !(locationOrUri instanceof code.Uri);
			super(name, kind, containerName, hasRange ? locationOrUri : new code.Location(locationOrUri, new code.Range(0, 0, 0, 0)));
			this.hasRange = hasRange;
			if (data !== void 0) this.data = data;
		}
	};
	exports.default = WorkspaceSymbol;
}));
// node_modules/vscode-languageclient/lib/common/protocolInlayHint.js
var require_protocolInlayHint = /* @__PURE__ */ __commonJSMin(((exports, module, this$19) => {
	var __createBinding = this$19 && this$19.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$19 && this$19.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$19 && this$19.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	Object.defineProperty(exports, "__esModule", { value: true });
	var code = __importStar(require("vscode"));
	var ProtocolInlayHint = class extends code.InlayHint {
		data;
		constructor(position, label, kind) {
			super(position, label, kind);
		}
	};
	exports.default = ProtocolInlayHint;
}));
// node_modules/vscode-languageclient/lib/common/codeConverter.js
var require_codeConverter = /* @__PURE__ */ __commonJSMin(((exports, module, this$18) => {
	var __createBinding = this$18 && this$18.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$18 && this$18.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$18 && this$18.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	var __importDefault = this$18 && this$18.__importDefault || function(mod) {
		return mod && mod.__esModule ? mod : { "default": mod };
	};
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.createConverter = createConverter;
	var code = __importStar(require("vscode"));
	var proto = __importStar(require_api$1());
	var Is = __importStar(require_is$2());
	var async = __importStar(require_async());
	var protocolCompletionItem_1 = __importDefault(require_protocolCompletionItem());
	var protocolCodeLens_1 = __importDefault(require_protocolCodeLens());
	var protocolDocumentLink_1 = __importDefault(require_protocolDocumentLink());
	var protocolCodeAction_1 = __importDefault(require_protocolCodeAction());
	var protocolDiagnostic_1 = require_protocolDiagnostic();
	var protocolCallHierarchyItem_1 = __importDefault(require_protocolCallHierarchyItem());
	var protocolTypeHierarchyItem_1 = __importDefault(require_protocolTypeHierarchyItem());
	var protocolWorkspaceSymbol_1 = __importDefault(require_protocolWorkspaceSymbol());
	var protocolInlayHint_1 = __importDefault(require_protocolInlayHint());
	var InsertReplaceRange;
	(function(InsertReplaceRange) {
		function is(value) {
			const candidate = value;
			return candidate && !!candidate.inserting && !!candidate.replacing;
		}
		InsertReplaceRange.is = is;
	})(InsertReplaceRange || (InsertReplaceRange = {}));
	function createConverter(uriConverter) {
		const nullConverter = (value) => value.toString();
		const _uriConverter = uriConverter || nullConverter;
		function asUri(value) {
			return _uriConverter(value);
		}
		function asTextDocumentIdentifier(textDocument) {
			return { uri: _uriConverter(textDocument.uri) };
		}
		function asTextDocumentItem(textDocument) {
			return {
				uri: _uriConverter(textDocument.uri),
				languageId: textDocument.languageId,
				version: textDocument.version,
				text: textDocument.getText()
			};
		}
		function asVersionedTextDocumentIdentifier(textDocument) {
			return {
				uri: _uriConverter(textDocument.uri),
				version: textDocument.version
			};
		}
		function asOpenTextDocumentParams(textDocument) {
			return { textDocument: asTextDocumentItem(textDocument) };
		}
		function isTextDocumentChangeEvent(value) {
			const candidate = value;
			return !!candidate.document && !!candidate.contentChanges;
		}
		function isTextDocument(value) {
			const candidate = value;
			return !!candidate.uri && !!candidate.version;
		}
		function asChangeTextDocumentParams(arg0, arg1, arg2) {
			if (isTextDocument(arg0)) return {
				textDocument: {
					uri: _uriConverter(arg0.uri),
					version: arg0.version
				},
				contentChanges: [{ text: arg0.getText() }]
			};
			else if (isTextDocumentChangeEvent(arg0)) {
				const uri = arg1;
				const version = arg2;
				return {
					textDocument: {
						uri: _uriConverter(uri),
						version
					},
					contentChanges: arg0.contentChanges.map((change) => {
						const range = change.range;
						return {
							range: {
								start: {
									line: range.start.line,
									character: range.start.character
								},
								end: {
									line: range.end.line,
									character: range.end.character
								}
							},
							rangeLength: change.rangeLength,
							text: change.text
						};
					})
				};
			} else throw Error("Unsupported text document change parameter");
		}
		function asCloseTextDocumentParams(textDocument) {
			return { textDocument: asTextDocumentIdentifier(textDocument) };
		}
		function asSaveTextDocumentParams(textDocument, includeContent = false) {
			const result = { textDocument: asTextDocumentIdentifier(textDocument) };
			if (includeContent) result.text = textDocument.getText();
			return result;
		}
		function asTextDocumentSaveReason(reason) {
			switch (reason) {
				case code.TextDocumentSaveReason.Manual: return proto.TextDocumentSaveReason.Manual;
				case code.TextDocumentSaveReason.AfterDelay: return proto.TextDocumentSaveReason.AfterDelay;
				case code.TextDocumentSaveReason.FocusOut: return proto.TextDocumentSaveReason.FocusOut;
			}
			return proto.TextDocumentSaveReason.Manual;
		}
		function asWillSaveTextDocumentParams(event) {
			return {
				textDocument: asTextDocumentIdentifier(event.document),
				reason: asTextDocumentSaveReason(event.reason)
			};
		}
		function asDidCreateFilesParams(event) {
			return { files: event.files.map((fileUri) => ({ uri: _uriConverter(fileUri) })) };
		}
		function asDidRenameFilesParams(event) {
			return { files: event.files.map((file) => ({
				oldUri: _uriConverter(file.oldUri),
				newUri: _uriConverter(file.newUri)
			})) };
		}
		function asDidDeleteFilesParams(event) {
			return { files: event.files.map((fileUri) => ({ uri: _uriConverter(fileUri) })) };
		}
		function asWillCreateFilesParams(event) {
			return { files: event.files.map((fileUri) => ({ uri: _uriConverter(fileUri) })) };
		}
		function asWillRenameFilesParams(event) {
			return { files: event.files.map((file) => ({
				oldUri: _uriConverter(file.oldUri),
				newUri: _uriConverter(file.newUri)
			})) };
		}
		function asWillDeleteFilesParams(event) {
			return { files: event.files.map((fileUri) => ({ uri: _uriConverter(fileUri) })) };
		}
		function asTextDocumentPositionParams(textDocument, position) {
			return {
				textDocument: asTextDocumentIdentifier(textDocument),
				position: asWorkerPosition(position)
			};
		}
		function asCompletionTriggerKind(triggerKind) {
			switch (triggerKind) {
				case code.CompletionTriggerKind.TriggerCharacter: return proto.CompletionTriggerKind.TriggerCharacter;
				case code.CompletionTriggerKind.TriggerForIncompleteCompletions: return proto.CompletionTriggerKind.TriggerForIncompleteCompletions;
				default: return proto.CompletionTriggerKind.Invoked;
			}
		}
		function asCompletionParams(textDocument, position, context) {
			return {
				textDocument: asTextDocumentIdentifier(textDocument),
				position: asWorkerPosition(position),
				context: {
					triggerKind: asCompletionTriggerKind(context.triggerKind),
					triggerCharacter: context.triggerCharacter
				}
			};
		}
		function asSignatureHelpTriggerKind(triggerKind) {
			switch (triggerKind) {
				case code.SignatureHelpTriggerKind.Invoke: return proto.SignatureHelpTriggerKind.Invoked;
				case code.SignatureHelpTriggerKind.TriggerCharacter: return proto.SignatureHelpTriggerKind.TriggerCharacter;
				case code.SignatureHelpTriggerKind.ContentChange: return proto.SignatureHelpTriggerKind.ContentChange;
			}
		}
		function asParameterInformation(value) {
			return { label: value.label };
		}
		function asParameterInformations(values) {
			return values.map(asParameterInformation);
		}
		function asSignatureInformation(value) {
			return {
				label: value.label,
				parameters: asParameterInformations(value.parameters)
			};
		}
		function asSignatureInformations(values) {
			return values.map(asSignatureInformation);
		}
		function asSignatureHelp(value) {
			if (value === void 0) return value;
			return {
				signatures: asSignatureInformations(value.signatures),
				activeSignature: value.activeSignature,
				activeParameter: value.activeParameter
			};
		}
		function asSignatureHelpParams(textDocument, position, context) {
			return {
				textDocument: asTextDocumentIdentifier(textDocument),
				position: asWorkerPosition(position),
				context: {
					isRetrigger: context.isRetrigger,
					triggerCharacter: context.triggerCharacter,
					triggerKind: asSignatureHelpTriggerKind(context.triggerKind),
					activeSignatureHelp: asSignatureHelp(context.activeSignatureHelp)
				}
			};
		}
		function asWorkerPosition(position) {
			return {
				line: position.line,
				character: position.character
			};
		}
		function asPosition(value) {
			if (value === void 0 || value === null) return value;
			return {
				line: value.line > proto.uinteger.MAX_VALUE ? proto.uinteger.MAX_VALUE : value.line,
				character: value.character > proto.uinteger.MAX_VALUE ? proto.uinteger.MAX_VALUE : value.character
			};
		}
		function asPositions(values, token) {
			return async.map(values, asPosition, token);
		}
		function asPositionsSync(values) {
			return values.map(asPosition);
		}
		function asRange(value) {
			if (value === void 0 || value === null) return value;
			return {
				start: asPosition(value.start),
				end: asPosition(value.end)
			};
		}
		function asRanges(values) {
			return values.map(asRange);
		}
		function asLocation(value) {
			if (value === void 0 || value === null) return value;
			return proto.Location.create(asUri(value.uri), asRange(value.range));
		}
		function asDiagnosticSeverity(value) {
			switch (value) {
				case code.DiagnosticSeverity.Error: return proto.DiagnosticSeverity.Error;
				case code.DiagnosticSeverity.Warning: return proto.DiagnosticSeverity.Warning;
				case code.DiagnosticSeverity.Information: return proto.DiagnosticSeverity.Information;
				case code.DiagnosticSeverity.Hint: return proto.DiagnosticSeverity.Hint;
			}
		}
		function asDiagnosticTags(tags) {
			if (!tags) return;
			const result = [];
			for (const tag of tags) {
				const converted = asDiagnosticTag(tag);
				if (converted !== void 0) result.push(converted);
			}
			return result.length > 0 ? result : void 0;
		}
		function asDiagnosticTag(tag) {
			switch (tag) {
				case code.DiagnosticTag.Unnecessary: return proto.DiagnosticTag.Unnecessary;
				case code.DiagnosticTag.Deprecated: return proto.DiagnosticTag.Deprecated;
				default: return;
			}
		}
		function asRelatedInformation(item) {
			return {
				message: item.message,
				location: asLocation(item.location)
			};
		}
		function asRelatedInformations(items) {
			return items.map(asRelatedInformation);
		}
		function asDiagnosticCode(value) {
			if (value === void 0 || value === null) return;
			if (Is.number(value) || Is.string(value)) return value;
			return {
				value: value.value,
				target: asUri(value.target)
			};
		}
		function asDiagnostic(item) {
			const result = proto.Diagnostic.create(asRange(item.range), item.message);
			const protocolDiagnostic = item instanceof protocolDiagnostic_1.ProtocolDiagnostic ? item : void 0;
			if (protocolDiagnostic !== void 0 && protocolDiagnostic.data !== void 0) result.data = protocolDiagnostic.data;
			const code = asDiagnosticCode(item.code);
			if (protocolDiagnostic_1.DiagnosticCode.is(code)) {
				if (protocolDiagnostic !== void 0 && protocolDiagnostic.hasDiagnosticCode) result.code = code;
				else {
					result.code = code.value;
					result.codeDescription = { href: code.target };
				}
			} else result.code = code;
			if (Is.number(item.severity)) result.severity = asDiagnosticSeverity(item.severity);
			if (Array.isArray(item.tags)) result.tags = asDiagnosticTags(item.tags);
			if (item.relatedInformation) result.relatedInformation = asRelatedInformations(item.relatedInformation);
			if (item.source) result.source = item.source;
			return result;
		}
		function asDiagnostics(items, token) {
			if (items === void 0 || items === null) return items;
			return async.map(items, asDiagnostic, token);
		}
		function asDiagnosticsSync(items) {
			if (items === void 0 || items === null) return items;
			return items.map(asDiagnostic);
		}
		function asDocumentation(format, documentation) {
			switch (format) {
				case "$string": return documentation;
				case proto.MarkupKind.PlainText: return {
					kind: format,
					value: documentation
				};
				case proto.MarkupKind.Markdown: return {
					kind: format,
					value: documentation.value
				};
				default: return `Unsupported Markup content received. Kind is: ${format}`;
			}
		}
		function asCompletionItemTag(tag) {
			switch (tag) {
				case code.CompletionItemTag.Deprecated: return proto.CompletionItemTag.Deprecated;
			}
		}
		function asCompletionItemTags(tags) {
			if (tags === void 0) return tags;
			const result = [];
			for (const tag of tags) {
				const converted = asCompletionItemTag(tag);
				if (converted !== void 0) result.push(converted);
			}
			return result;
		}
		function asCompletionItemKind(value, original) {
			if (original !== void 0) return original;
			return value + 1;
		}
		function asCompletionItem(item, labelDetailsSupport = false) {
			let label;
			let labelDetails;
			if (Is.string(item.label)) label = item.label;
			else {
				label = item.label.label;
				if (labelDetailsSupport && (item.label.detail !== void 0 || item.label.description !== void 0)) labelDetails = {
					detail: item.label.detail,
					description: item.label.description
				};
			}
			const result = { label };
			if (labelDetails !== void 0) result.labelDetails = labelDetails;
			const protocolItem = item instanceof protocolCompletionItem_1.default ? item : void 0;
			if (item.detail) result.detail = item.detail;
			if (item.documentation) {
				if (!protocolItem || protocolItem.documentationFormat === "$string") result.documentation = item.documentation;
				else result.documentation = asDocumentation(protocolItem.documentationFormat, item.documentation);
			}
			if (item.filterText) result.filterText = item.filterText;
			fillPrimaryInsertText(result, item);
			if (Is.number(item.kind)) result.kind = asCompletionItemKind(item.kind, protocolItem && protocolItem.originalItemKind);
			if (item.sortText) result.sortText = item.sortText;
			if (item.additionalTextEdits) result.additionalTextEdits = asTextEdits(item.additionalTextEdits);
			if (item.commitCharacters) result.commitCharacters = item.commitCharacters.slice();
			if (item.command) result.command = asCommand(item.command);
			if (item.preselect === true || item.preselect === false) result.preselect = item.preselect;
			const tags = asCompletionItemTags(item.tags);
			if (protocolItem) {
				if (protocolItem.data !== void 0) result.data = protocolItem.data;
				if (protocolItem.deprecated === true || protocolItem.deprecated === false) {
					if (protocolItem.deprecated === true && tags !== void 0 && tags.length > 0) {
						const index = tags.indexOf(code.CompletionItemTag.Deprecated);
						if (index !== -1) tags.splice(index, 1);
					}
					result.deprecated = protocolItem.deprecated;
				}
				if (protocolItem.insertTextMode !== void 0) result.insertTextMode = protocolItem.insertTextMode;
			}
			if (tags !== void 0 && tags.length > 0) result.tags = tags;
			if (result.insertTextMode === void 0 && item.keepWhitespace === true) result.insertTextMode = proto.InsertTextMode.adjustIndentation;
			return result;
		}
		function fillPrimaryInsertText(target, source) {
			let format = proto.InsertTextFormat.PlainText;
			let text = void 0;
			let range = void 0;
			if (source.textEdit) {
				text = source.textEdit.newText;
				range = source.textEdit.range;
			} else if (source.insertText instanceof code.SnippetString) {
				format = proto.InsertTextFormat.Snippet;
				text = source.insertText.value;
			} else text = source.insertText;
			if (source.range) range = source.range;
			target.insertTextFormat = format;
			if (source.fromEdit && text !== void 0 && range !== void 0) target.textEdit = asCompletionTextEdit(text, range);
			else target.insertText = text;
		}
		function asCompletionTextEdit(newText, range) {
			if (InsertReplaceRange.is(range)) return proto.InsertReplaceEdit.create(newText, asRange(range.inserting), asRange(range.replacing));
			else return {
				newText,
				range: asRange(range)
			};
		}
		function asTextEdit(edit) {
			return {
				range: asRange(edit.range),
				newText: edit.newText
			};
		}
		function asTextEdits(edits) {
			if (edits === void 0 || edits === null) return edits;
			return edits.map(asTextEdit);
		}
		function asSymbolKind(item) {
			if (item <= code.SymbolKind.TypeParameter) return item + 1;
			return proto.SymbolKind.Property;
		}
		function asSymbolTag(item) {
			return item;
		}
		function asSymbolTags(items) {
			return items.map(asSymbolTag);
		}
		function asReferenceParams(textDocument, position, options) {
			return {
				textDocument: asTextDocumentIdentifier(textDocument),
				position: asWorkerPosition(position),
				context: { includeDeclaration: options.includeDeclaration }
			};
		}
		async function asCodeAction(item, token) {
			const result = proto.CodeAction.create(item.title);
			if (item instanceof protocolCodeAction_1.default && item.data !== void 0) result.data = item.data;
			if (item.kind !== void 0) result.kind = asCodeActionKind(item.kind);
			if (item.diagnostics !== void 0) result.diagnostics = await asDiagnostics(item.diagnostics, token);
			if (item.edit !== void 0) throw new Error(`VS Code code actions can only be converted to a protocol code action without an edit.`);
			if (item.command !== void 0) result.command = asCommand(item.command);
			if (item.isPreferred !== void 0) result.isPreferred = item.isPreferred;
			if (item.disabled !== void 0) result.disabled = { reason: item.disabled.reason };
			if (item.isAI) {
				result.tags ??= [];
				result.tags.push(proto.CodeActionTag.LLMGenerated);
			}
			return result;
		}
		function asCodeActionSync(item) {
			const result = proto.CodeAction.create(item.title);
			if (item instanceof protocolCodeAction_1.default && item.data !== void 0) result.data = item.data;
			if (item.kind !== void 0) result.kind = asCodeActionKind(item.kind);
			if (item.diagnostics !== void 0) result.diagnostics = asDiagnosticsSync(item.diagnostics);
			if (item.edit !== void 0) throw new Error(`VS Code code actions can only be converted to a protocol code action without an edit.`);
			if (item.command !== void 0) result.command = asCommand(item.command);
			if (item.isPreferred !== void 0) result.isPreferred = item.isPreferred;
			if (item.disabled !== void 0) result.disabled = { reason: item.disabled.reason };
			if (item.isAI) {
				result.tags ??= [];
				result.tags.push(proto.CodeActionTag.LLMGenerated);
			}
			return result;
		}
		async function asCodeActionContext(context, token) {
			if (context === void 0 || context === null) return context;
			let only;
			if (context.only && Is.string(context.only.value)) only = [context.only.value];
			return proto.CodeActionContext.create(await asDiagnostics(context.diagnostics, token), only, asCodeActionTriggerKind(context.triggerKind));
		}
		function asCodeActionContextSync(context) {
			if (context === void 0 || context === null) return context;
			let only;
			if (context.only && Is.string(context.only.value)) only = [context.only.value];
			return proto.CodeActionContext.create(asDiagnosticsSync(context.diagnostics), only, asCodeActionTriggerKind(context.triggerKind));
		}
		function asCodeActionTriggerKind(kind) {
			switch (kind) {
				case code.CodeActionTriggerKind.Invoke: return proto.CodeActionTriggerKind.Invoked;
				case code.CodeActionTriggerKind.Automatic: return proto.CodeActionTriggerKind.Automatic;
				default: return;
			}
		}
		function asCodeActionKind(item) {
			if (item === void 0 || item === null) return;
			return item.value;
		}
		function asInlineValueContext(context) {
			return proto.InlineValueContext.create(context.frameId, asRange(context.stoppedLocation));
		}
		function asInlineCompletionParams(document, position, context) {
			return {
				textDocument: asTextDocumentIdentifier(document),
				position: asPosition(position),
				context: asInlineCompletionContext(context)
			};
		}
		function asInlineCompletionContext(context) {
			return {
				triggerKind: asInlineCompletionTriggerKind(context.triggerKind),
				selectedCompletionInfo: asSelectedCompletionInfo(context.selectedCompletionInfo)
			};
		}
		function asInlineCompletionTriggerKind(kind) {
			switch (kind) {
				case code.InlineCompletionTriggerKind.Invoke: return proto.InlineCompletionTriggerKind.Invoked;
				case code.InlineCompletionTriggerKind.Automatic: return proto.InlineCompletionTriggerKind.Automatic;
			}
		}
		function asSelectedCompletionInfo(info) {
			if (info === void 0 || info === null) return;
			return {
				range: asRange(info.range),
				text: info.text
			};
		}
		function asCommand(item) {
			const result = proto.Command.create(item.title, item.command);
			if (item.tooltip) result.tooltip = item.tooltip;
			if (item.arguments) result.arguments = item.arguments;
			return result;
		}
		function asCodeLens(item) {
			const result = proto.CodeLens.create(asRange(item.range));
			if (item.command) result.command = asCommand(item.command);
			if (item instanceof protocolCodeLens_1.default) {
				if (item.data) result.data = item.data;
			}
			return result;
		}
		function asFormattingOptions(options, fileOptions) {
			const result = {
				tabSize: options.tabSize,
				insertSpaces: options.insertSpaces
			};
			if (fileOptions.trimTrailingWhitespace) result.trimTrailingWhitespace = true;
			if (fileOptions.trimFinalNewlines) result.trimFinalNewlines = true;
			if (fileOptions.insertFinalNewline) result.insertFinalNewline = true;
			return result;
		}
		function asDocumentSymbolParams(textDocument) {
			return { textDocument: asTextDocumentIdentifier(textDocument) };
		}
		function asCodeLensParams(textDocument) {
			return { textDocument: asTextDocumentIdentifier(textDocument) };
		}
		function asDocumentLink(item) {
			const result = proto.DocumentLink.create(asRange(item.range));
			if (item.target) result.target = asUri(item.target);
			if (item.tooltip !== void 0) result.tooltip = item.tooltip;
			const protocolItem = item instanceof protocolDocumentLink_1.default ? item : void 0;
			if (protocolItem && protocolItem.data) result.data = protocolItem.data;
			return result;
		}
		function asDocumentLinkParams(textDocument) {
			return { textDocument: asTextDocumentIdentifier(textDocument) };
		}
		function asCallHierarchyItem(value) {
			const result = {
				name: value.name,
				kind: asSymbolKind(value.kind),
				uri: asUri(value.uri),
				range: asRange(value.range),
				selectionRange: asRange(value.selectionRange)
			};
			if (value.detail !== void 0 && value.detail.length > 0) result.detail = value.detail;
			if (value.tags !== void 0) result.tags = asSymbolTags(value.tags);
			if (value instanceof protocolCallHierarchyItem_1.default && value.data !== void 0) result.data = value.data;
			return result;
		}
		function asTypeHierarchyItem(value) {
			const result = {
				name: value.name,
				kind: asSymbolKind(value.kind),
				uri: asUri(value.uri),
				range: asRange(value.range),
				selectionRange: asRange(value.selectionRange)
			};
			if (value.detail !== void 0 && value.detail.length > 0) result.detail = value.detail;
			if (value.tags !== void 0) result.tags = asSymbolTags(value.tags);
			if (value instanceof protocolTypeHierarchyItem_1.default && value.data !== void 0) result.data = value.data;
			return result;
		}
		function asWorkspaceSymbol(item) {
			const result = item instanceof protocolWorkspaceSymbol_1.default ? {
				name: item.name,
				kind: asSymbolKind(item.kind),
				location: item.hasRange ? asLocation(item.location) : { uri: _uriConverter(item.location.uri) },
				data: item.data
			} : {
				name: item.name,
				kind: asSymbolKind(item.kind),
				location: asLocation(item.location)
			};
			if (item.tags !== void 0) result.tags = asSymbolTags(item.tags);
			if (item.containerName !== "") result.containerName = item.containerName;
			return result;
		}
		function asInlayHint(item) {
			const label = typeof item.label === "string" ? item.label : item.label.map(asInlayHintLabelPart);
			const result = proto.InlayHint.create(asPosition(item.position), label);
			if (item.kind !== void 0) result.kind = item.kind;
			if (item.textEdits !== void 0) result.textEdits = asTextEdits(item.textEdits);
			if (item.tooltip !== void 0) result.tooltip = asTooltip(item.tooltip);
			if (item.paddingLeft !== void 0) result.paddingLeft = item.paddingLeft;
			if (item.paddingRight !== void 0) result.paddingRight = item.paddingRight;
			if (item instanceof protocolInlayHint_1.default && item.data !== void 0) result.data = item.data;
			return result;
		}
		function asInlayHintLabelPart(item) {
			const result = proto.InlayHintLabelPart.create(item.value);
			if (item.location !== void 0) result.location = asLocation(item.location);
			if (item.command !== void 0) result.command = asCommand(item.command);
			if (item.tooltip !== void 0) result.tooltip = asTooltip(item.tooltip);
			return result;
		}
		function asTooltip(value) {
			if (typeof value === "string") return value;
			return {
				kind: proto.MarkupKind.Markdown,
				value: value.value
			};
		}
		return {
			asUri,
			asTextDocumentIdentifier,
			asTextDocumentItem,
			asVersionedTextDocumentIdentifier,
			asOpenTextDocumentParams,
			asChangeTextDocumentParams,
			asCloseTextDocumentParams,
			asSaveTextDocumentParams,
			asWillSaveTextDocumentParams,
			asDidCreateFilesParams,
			asDidRenameFilesParams,
			asDidDeleteFilesParams,
			asWillCreateFilesParams,
			asWillRenameFilesParams,
			asWillDeleteFilesParams,
			asTextDocumentPositionParams,
			asCompletionParams,
			asSignatureHelpParams,
			asWorkerPosition,
			asRange,
			asRanges,
			asPosition,
			asPositions,
			asPositionsSync,
			asLocation,
			asDiagnosticSeverity,
			asDiagnosticTag,
			asDiagnostic,
			asDiagnostics,
			asDiagnosticsSync,
			asCompletionItem,
			asTextEdit,
			asSymbolKind,
			asSymbolTag,
			asSymbolTags,
			asReferenceParams,
			asCodeAction,
			asCodeActionSync,
			asCodeActionContext,
			asCodeActionContextSync,
			asInlineValueContext,
			asCommand,
			asCodeLens,
			asFormattingOptions,
			asDocumentSymbolParams,
			asCodeLensParams,
			asDocumentLink,
			asDocumentLinkParams,
			asCallHierarchyItem,
			asTypeHierarchyItem,
			asInlayHint,
			asWorkspaceSymbol,
			asInlineCompletionParams,
			asInlineCompletionContext
		};
	}
}));
// node_modules/vscode-languageclient/lib/common/protocolConverter.js
var require_protocolConverter = /* @__PURE__ */ __commonJSMin(((exports, module, this$17) => {
	var __createBinding = this$17 && this$17.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$17 && this$17.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$17 && this$17.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	var __importDefault = this$17 && this$17.__importDefault || function(mod) {
		return mod && mod.__esModule ? mod : { "default": mod };
	};
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.createConverter = createConverter;
	var code = __importStar(require("vscode"));
	var ls = __importStar(require_api$1());
	var Is = __importStar(require_is$2());
	var async = __importStar(require_async());
	var protocolCompletionItem_1 = __importDefault(require_protocolCompletionItem());
	var protocolCodeLens_1 = __importDefault(require_protocolCodeLens());
	var protocolDocumentLink_1 = __importDefault(require_protocolDocumentLink());
	var protocolCodeAction_1 = __importDefault(require_protocolCodeAction());
	var protocolDiagnostic_1 = require_protocolDiagnostic();
	var protocolCallHierarchyItem_1 = __importDefault(require_protocolCallHierarchyItem());
	var protocolTypeHierarchyItem_1 = __importDefault(require_protocolTypeHierarchyItem());
	var protocolWorkspaceSymbol_1 = __importDefault(require_protocolWorkspaceSymbol());
	var protocolInlayHint_1 = __importDefault(require_protocolInlayHint());
	var vscode_languageserver_protocol_1 = require_api$1();
	var CodeBlock;
	(function(CodeBlock) {
		function is(value) {
			const candidate = value;
			return candidate && Is.string(candidate.language) && Is.string(candidate.value);
		}
		CodeBlock.is = is;
	})(CodeBlock || (CodeBlock = {}));
	function createConverter(uriConverter, trustMarkdown, supportHtml, supportThemeIcons) {
		const nullConverter = (value) => code.Uri.parse(value);
		const _uriConverter = uriConverter || nullConverter;
		function asUri(value) {
			return _uriConverter(value);
		}
		function asDocumentSelector(selector) {
			const result = [];
			for (const filter of selector) if (typeof filter === "string") result.push(filter);
			else if (vscode_languageserver_protocol_1.NotebookCellTextDocumentFilter.is(filter)) {
				if (typeof filter.notebook === "string") result.push({
					notebookType: filter.notebook,
					language: filter.language
				});
				else {
					const notebookType = filter.notebook.notebookType ?? "*";
					result.push({
						notebookType,
						scheme: filter.notebook.scheme,
						pattern: asGlobPattern(filter.notebook.pattern),
						language: filter.language
					});
				}
			} else if (vscode_languageserver_protocol_1.TextDocumentFilter.is(filter)) result.push({
				language: filter.language,
				scheme: filter.scheme,
				pattern: asGlobPattern(filter.pattern)
			});
			return result;
		}
		async function asDiagnostics(diagnostics, token) {
			return async.map(diagnostics, asDiagnostic, token);
		}
		function asDiagnosticsSync(diagnostics) {
			const result = new Array(diagnostics.length);
			for (let i = 0; i < diagnostics.length; i++) result[i] = asDiagnostic(diagnostics[i]);
			return result;
		}
		function asDiagnostic(diagnostic) {
			const message = typeof diagnostic.message === "string" ? diagnostic.message : diagnostic.message.kind === "plaintext" ? diagnostic.message.value : "Received a markup diagnostic message but the client does not support it.";
			const result = new protocolDiagnostic_1.ProtocolDiagnostic(asRange(diagnostic.range), message, asDiagnosticSeverity(diagnostic.severity), diagnostic.data);
			if (diagnostic.code !== void 0) {
				if (typeof diagnostic.code === "string" || typeof diagnostic.code === "number") {
					if (ls.CodeDescription.is(diagnostic.codeDescription)) result.code = {
						value: diagnostic.code,
						target: asUri(diagnostic.codeDescription.href)
					};
					else result.code = diagnostic.code;
				} else if (protocolDiagnostic_1.DiagnosticCode.is(diagnostic.code)) {
					result.hasDiagnosticCode = true;
					const diagnosticCode = diagnostic.code;
					result.code = {
						value: diagnosticCode.value,
						target: asUri(diagnosticCode.target)
					};
				}
			}
			if (diagnostic.source) result.source = diagnostic.source;
			if (diagnostic.relatedInformation) result.relatedInformation = asRelatedInformation(diagnostic.relatedInformation);
			if (Array.isArray(diagnostic.tags)) result.tags = asDiagnosticTags(diagnostic.tags);
			return result;
		}
		function asRelatedInformation(relatedInformation) {
			const result = new Array(relatedInformation.length);
			for (let i = 0; i < relatedInformation.length; i++) {
				const info = relatedInformation[i];
				result[i] = new code.DiagnosticRelatedInformation(asLocation(info.location), info.message);
			}
			return result;
		}
		function asDiagnosticTags(tags) {
			if (!tags) return;
			const result = [];
			for (const tag of tags) {
				const converted = asDiagnosticTag(tag);
				if (converted !== void 0) result.push(converted);
			}
			return result.length > 0 ? result : void 0;
		}
		function asDiagnosticTag(tag) {
			switch (tag) {
				case ls.DiagnosticTag.Unnecessary: return code.DiagnosticTag.Unnecessary;
				case ls.DiagnosticTag.Deprecated: return code.DiagnosticTag.Deprecated;
				default: return;
			}
		}
		function asPosition(value) {
			return value ? new code.Position(value.line, value.character) : void 0;
		}
		function asRange(value) {
			return value ? new code.Range(value.start.line, value.start.character, value.end.line, value.end.character) : void 0;
		}
		async function asRanges(items, token) {
			return async.map(items, (range) => {
				return new code.Range(range.start.line, range.start.character, range.end.line, range.end.character);
			}, token);
		}
		function asDiagnosticSeverity(value) {
			if (value === void 0 || value === null) return code.DiagnosticSeverity.Error;
			switch (value) {
				case ls.DiagnosticSeverity.Error: return code.DiagnosticSeverity.Error;
				case ls.DiagnosticSeverity.Warning: return code.DiagnosticSeverity.Warning;
				case ls.DiagnosticSeverity.Information: return code.DiagnosticSeverity.Information;
				case ls.DiagnosticSeverity.Hint: return code.DiagnosticSeverity.Hint;
			}
			return code.DiagnosticSeverity.Error;
		}
		function asHoverContent(value) {
			if (Is.string(value)) return asMarkdownString(value);
			else if (CodeBlock.is(value)) return asMarkdownString().appendCodeblock(value.value, value.language);
			else if (Array.isArray(value)) {
				const result = [];
				for (const element of value) {
					const item = asMarkdownString();
					if (CodeBlock.is(element)) item.appendCodeblock(element.value, element.language);
					else item.appendMarkdown(element);
					result.push(item);
				}
				return result;
			} else return asMarkdownString(value);
		}
		function asDocumentation(value) {
			if (Is.string(value)) return value;
			else switch (value.kind) {
				case ls.MarkupKind.Markdown: return asMarkdownString(value.value);
				case ls.MarkupKind.PlainText: return value.value;
				default: return `Unsupported Markup content received. Kind is: ${value.kind}`;
			}
		}
		function asMarkdownString(value) {
			let result;
			if (value === void 0 || typeof value === "string") result = new code.MarkdownString(value);
			else switch (value.kind) {
				case ls.MarkupKind.Markdown:
					result = new code.MarkdownString(value.value);
					break;
				case ls.MarkupKind.PlainText:
					result = new code.MarkdownString();
					result.appendText(value.value);
					break;
				default:
					result = new code.MarkdownString();
					result.appendText(`Unsupported Markup content received. Kind is: ${value.kind}`);
			}
			result.isTrusted = trustMarkdown;
			result.supportHtml = supportHtml;
			result.supportThemeIcons = supportThemeIcons;
			return result;
		}
		function asHover(hover) {
			if (!hover) return;
			return new code.Hover(asHoverContent(hover.contents), asRange(hover.range));
		}
		async function asCompletionResult(value, allCommitCharacters, token) {
			if (!value) return;
			if (Array.isArray(value)) return async.map(value, (item) => asCompletionItem(item, allCommitCharacters), token);
			const list = value;
			const { defaultRange, commitCharacters } = getCompletionItemDefaults(list, allCommitCharacters);
			const converted = await async.map(list.items, (item) => {
				return asCompletionItem(item, commitCharacters, list.applyKind?.commitCharacters, defaultRange, list.itemDefaults?.insertTextMode, list.itemDefaults?.insertTextFormat, list.itemDefaults?.data, list.applyKind?.data);
			}, token);
			return new code.CompletionList(converted, list.isIncomplete);
		}
		function getCompletionItemDefaults(list, allCommitCharacters) {
			const rangeDefaults = list.itemDefaults?.editRange;
			const commitCharacters = list.itemDefaults?.commitCharacters ?? allCommitCharacters;
			return ls.Range.is(rangeDefaults) ? {
				defaultRange: asRange(rangeDefaults),
				commitCharacters
			} : rangeDefaults !== void 0 ? {
				defaultRange: {
					inserting: asRange(rangeDefaults.insert),
					replacing: asRange(rangeDefaults.replace)
				},
				commitCharacters
			} : {
				defaultRange: void 0,
				commitCharacters
			};
		}
		function asCompletionItemKind(value) {
			if (ls.CompletionItemKind.Text <= value && value <= ls.CompletionItemKind.TypeParameter) return [value - 1, void 0];
			return [code.CompletionItemKind.Text, value];
		}
		function asCompletionItemTag(tag) {
			switch (tag) {
				case ls.CompletionItemTag.Deprecated: return code.CompletionItemTag.Deprecated;
			}
		}
		function asCompletionItemTags(tags) {
			if (tags === void 0 || tags === null) return [];
			const result = [];
			for (const tag of tags) {
				const converted = asCompletionItemTag(tag);
				if (converted !== void 0) result.push(converted);
			}
			return result;
		}
		function asCompletionItem(item, defaultCommitCharacters, commitCharactersApplyKind, defaultRange, defaultInsertTextMode, defaultInsertTextFormat, defaultData, dataApplyKind) {
			const tags = asCompletionItemTags(item.tags);
			const label = asCompletionItemLabel(item);
			const result = new protocolCompletionItem_1.default(label);
			if (item.detail) result.detail = item.detail;
			if (item.documentation) {
				result.documentation = asDocumentation(item.documentation);
				result.documentationFormat = Is.string(item.documentation) ? "$string" : item.documentation.kind;
			}
			if (item.filterText) result.filterText = item.filterText;
			const insertText = asCompletionInsertText(item, defaultRange, defaultInsertTextFormat);
			if (insertText) {
				result.insertText = insertText.text;
				result.range = insertText.range;
				result.fromEdit = insertText.fromEdit;
			}
			if (Is.number(item.kind)) {
				const [itemKind, original] = asCompletionItemKind(item.kind);
				result.kind = itemKind;
				if (original) result.originalItemKind = original;
			}
			if (item.sortText) result.sortText = item.sortText;
			if (item.additionalTextEdits) result.additionalTextEdits = asTextEditsSync(item.additionalTextEdits);
			const commitCharacters = applyCommitCharacters(item, defaultCommitCharacters, commitCharactersApplyKind);
			if (commitCharacters) result.commitCharacters = commitCharacters.slice();
			if (item.command) result.command = asCommand(item.command);
			if (item.deprecated === true || item.deprecated === false) {
				result.deprecated = item.deprecated;
				if (item.deprecated === true) tags.push(code.CompletionItemTag.Deprecated);
			}
			if (item.preselect === true || item.preselect === false) result.preselect = item.preselect;
			const data = applyData(item, defaultData, dataApplyKind);
			if (data !== void 0) result.data = data;
			if (tags.length > 0) result.tags = tags;
			const insertTextMode = item.insertTextMode ?? defaultInsertTextMode;
			if (insertTextMode !== void 0) {
				result.insertTextMode = insertTextMode;
				if (insertTextMode === ls.InsertTextMode.asIs) result.keepWhitespace = true;
			}
			return result;
		}
		function applyCommitCharacters(item, defaultCommitCharacters, applyKind) {
			if (applyKind === ls.ApplyKind.Merge) {
				if (!defaultCommitCharacters && !item.commitCharacters) return;
				const set = /* @__PURE__ */ new Set();
				if (defaultCommitCharacters) for (const char of defaultCommitCharacters) set.add(char);
				if (Is.stringArray(item.commitCharacters)) for (const char of item.commitCharacters) set.add(char);
				return Array.from(set);
			}
			return item.commitCharacters !== void 0 ? Is.stringArray(item.commitCharacters) ? item.commitCharacters : void 0 : defaultCommitCharacters;
		}
		function applyData(item, defaultData, applyKind) {
			if (applyKind === ls.ApplyKind.Merge) {
				const data = { ...defaultData };
				if (item.data) Object.entries(item.data).forEach(([key, value]) => {
					if (value !== void 0 && value !== null) data[key] = value;
				});
				return data;
			}
			return item.data ?? defaultData;
		}
		function asCompletionItemLabel(item) {
			if (ls.CompletionItemLabelDetails.is(item.labelDetails)) return {
				label: item.label,
				detail: item.labelDetails.detail,
				description: item.labelDetails.description
			};
			else return item.label;
		}
		function asCompletionInsertText(item, defaultRange, defaultInsertTextFormat) {
			const insertTextFormat = item.insertTextFormat ?? defaultInsertTextFormat;
			if (item.textEdit !== void 0 || defaultRange !== void 0) {
				const [range, newText] = item.textEdit !== void 0 ? getCompletionRangeAndText(item.textEdit) : [defaultRange, item.textEditText ?? item.label];
				if (insertTextFormat === ls.InsertTextFormat.Snippet) return {
					text: new code.SnippetString(newText),
					range,
					fromEdit: true
				};
				else return {
					text: newText,
					range,
					fromEdit: true
				};
			} else if (item.insertText) {
				if (insertTextFormat === ls.InsertTextFormat.Snippet) return {
					text: new code.SnippetString(item.insertText),
					fromEdit: false
				};
				else return {
					text: item.insertText,
					fromEdit: false
				};
			} else return;
		}
		function getCompletionRangeAndText(value) {
			if (ls.InsertReplaceEdit.is(value)) return [{
				inserting: asRange(value.insert),
				replacing: asRange(value.replace)
			}, value.newText];
			else return [asRange(value.range), value.newText];
		}
		function asTextEdit(edit) {
			if (!edit) return;
			return new code.TextEdit(asRange(edit.range), edit.newText);
		}
		async function asTextEdits(items, token) {
			if (!items) return;
			return async.map(items, asTextEdit, token);
		}
		function asTextEditsSync(items) {
			if (!items) return;
			const result = new Array(items.length);
			for (let i = 0; i < items.length; i++) result[i] = asTextEdit(items[i]);
			return result;
		}
		async function asSignatureHelp(item, token) {
			if (!item) return;
			const result = new code.SignatureHelp();
			if (Is.number(item.activeSignature)) result.activeSignature = item.activeSignature;
			else result.activeSignature = 0;
			if (Is.number(item.activeParameter)) result.activeParameter = item.activeParameter;
			else if (item.activeParameter === null) result.activeParameter = -1;
			else result.activeParameter = 0;
			if (item.signatures) result.signatures = await asSignatureInformations(item.signatures, token);
			return result;
		}
		async function asSignatureInformations(items, token) {
			return async.mapAsync(items, asSignatureInformation, token);
		}
		async function asSignatureInformation(item, token) {
			const result = new code.SignatureInformation(item.label);
			if (item.documentation !== void 0) result.documentation = asDocumentation(item.documentation);
			if (item.parameters !== void 0) result.parameters = await asParameterInformations(item.parameters, token);
			if (item.activeParameter !== void 0) result.activeParameter = item.activeParameter ?? -1;
			return result;
		}
		function asParameterInformations(items, token) {
			return async.map(items, asParameterInformation, token);
		}
		function asParameterInformation(item) {
			const result = new code.ParameterInformation(item.label);
			if (item.documentation) result.documentation = asDocumentation(item.documentation);
			return result;
		}
		function asLocation(item) {
			return item ? new code.Location(_uriConverter(item.uri), asRange(item.range)) : void 0;
		}
		async function asDeclarationResult(item, token) {
			if (!item) return;
			return asLocationResult(item, token);
		}
		async function asDefinitionResult(item, token) {
			if (!item) return;
			return asLocationResult(item, token);
		}
		function asLocationLink(item) {
			if (!item) return;
			const result = {
				targetUri: _uriConverter(item.targetUri),
				targetRange: asRange(item.targetRange),
				originSelectionRange: asRange(item.originSelectionRange),
				targetSelectionRange: asRange(item.targetSelectionRange)
			};
			if (!result.targetSelectionRange) throw new Error(`targetSelectionRange must not be undefined or null`);
			return result;
		}
		async function asLocationResult(item, token) {
			if (!item) return;
			if (Is.array(item)) {
				if (item.length === 0) return [];
				else if (ls.LocationLink.is(item[0])) {
					const links = item;
					return async.map(links, asLocationLink, token);
				} else {
					const locations = item;
					return async.map(locations, asLocation, token);
				}
			} else if (ls.LocationLink.is(item)) return [asLocationLink(item)];
			else return asLocation(item);
		}
		async function asReferences(values, token) {
			if (!values) return;
			return async.map(values, asLocation, token);
		}
		async function asDocumentHighlights(values, token) {
			if (!values) return;
			return async.map(values, asDocumentHighlight, token);
		}
		function asDocumentHighlight(item) {
			const result = new code.DocumentHighlight(asRange(item.range));
			if (Is.number(item.kind)) result.kind = asDocumentHighlightKind(item.kind);
			return result;
		}
		function asDocumentHighlightKind(item) {
			switch (item) {
				case ls.DocumentHighlightKind.Text: return code.DocumentHighlightKind.Text;
				case ls.DocumentHighlightKind.Read: return code.DocumentHighlightKind.Read;
				case ls.DocumentHighlightKind.Write: return code.DocumentHighlightKind.Write;
			}
			return code.DocumentHighlightKind.Text;
		}
		async function asSymbolInformations(values, token) {
			if (!values) return;
			return async.map(values, asSymbolInformation, token);
		}
		function asSymbolKind(item) {
			if (item <= ls.SymbolKind.TypeParameter) return item - 1;
			return code.SymbolKind.Property;
		}
		function asSymbolTag(value) {
			switch (value) {
				case ls.SymbolTag.Deprecated: return code.SymbolTag.Deprecated;
				default: return;
			}
		}
		function asSymbolTags(items) {
			if (items === void 0 || items === null) return;
			const result = [];
			for (const item of items) {
				const converted = asSymbolTag(item);
				if (converted !== void 0) result.push(converted);
			}
			return result.length === 0 ? void 0 : result;
		}
		function asSymbolInformation(item) {
			const data = item.data;
			const location = item.location;
			const result = location.range === void 0 || data !== void 0 ? new protocolWorkspaceSymbol_1.default(item.name, asSymbolKind(item.kind), item.containerName ?? "", location.range === void 0 ? _uriConverter(location.uri) : new code.Location(_uriConverter(item.location.uri), asRange(location.range)), data) : new code.SymbolInformation(item.name, asSymbolKind(item.kind), item.containerName ?? "", new code.Location(_uriConverter(item.location.uri), asRange(location.range)));
			fillTags(result, item);
			return result;
		}
		async function asDocumentSymbols(values, token) {
			if (values === void 0 || values === null) return;
			return async.map(values, asDocumentSymbol, token);
		}
		function asDocumentSymbol(value) {
			const result = new code.DocumentSymbol(value.name, value.detail || "", asSymbolKind(value.kind), asRange(value.range), asRange(value.selectionRange));
			fillTags(result, value);
			if (value.children !== void 0 && value.children.length > 0) {
				const children = [];
				for (const child of value.children) children.push(asDocumentSymbol(child));
				result.children = children;
			}
			return result;
		}
		function fillTags(result, value) {
			result.tags = asSymbolTags(value.tags);
			if (value.deprecated) {
				if (!result.tags) result.tags = [code.SymbolTag.Deprecated];
				else if (!result.tags.includes(code.SymbolTag.Deprecated)) result.tags = result.tags.concat(code.SymbolTag.Deprecated);
			}
		}
		function asCommand(item) {
			const result = {
				title: item.title,
				command: item.command
			};
			if (item.tooltip) result.tooltip = item.tooltip;
			if (item.arguments) result.arguments = item.arguments;
			return result;
		}
		async function asCommands(items, token) {
			if (!items) return;
			return async.map(items, asCommand, token);
		}
		const kindMapping = /* @__PURE__ */ new Map();
		kindMapping.set(ls.CodeActionKind.Empty, code.CodeActionKind.Empty);
		kindMapping.set(ls.CodeActionKind.QuickFix, code.CodeActionKind.QuickFix);
		kindMapping.set(ls.CodeActionKind.Refactor, code.CodeActionKind.Refactor);
		kindMapping.set(ls.CodeActionKind.RefactorExtract, code.CodeActionKind.RefactorExtract);
		kindMapping.set(ls.CodeActionKind.RefactorInline, code.CodeActionKind.RefactorInline);
		kindMapping.set(ls.CodeActionKind.RefactorRewrite, code.CodeActionKind.RefactorRewrite);
		kindMapping.set(ls.CodeActionKind.Source, code.CodeActionKind.Source);
		kindMapping.set(ls.CodeActionKind.SourceOrganizeImports, code.CodeActionKind.SourceOrganizeImports);
		function asCodeActionKind(item) {
			if (item === void 0 || item === null) return;
			let result = kindMapping.get(item);
			if (result) return result;
			const parts = item.split(".");
			result = code.CodeActionKind.Empty;
			for (const part of parts) result = result.append(part);
			return result;
		}
		function asCodeActionKinds(items) {
			if (items === void 0 || items === null) return;
			return items.map((kind) => asCodeActionKind(kind));
		}
		function asCodeActionDocumentations(items) {
			if (items === void 0 || items === null) return;
			return items.map((doc) => ({
				kind: asCodeActionKind(doc.kind),
				command: asCommand(doc.command)
			}));
		}
		async function asCodeAction(item, token) {
			if (item === void 0 || item === null) return;
			const result = new protocolCodeAction_1.default(item.title, item.data);
			if (item.kind !== void 0) result.kind = asCodeActionKind(item.kind);
			if (item.diagnostics !== void 0) result.diagnostics = asDiagnosticsSync(item.diagnostics);
			if (item.edit !== void 0) result.edit = await asWorkspaceEdit(item.edit, token);
			if (item.command !== void 0) result.command = asCommand(item.command);
			if (item.isPreferred !== void 0) result.isPreferred = item.isPreferred;
			if (item.disabled !== void 0) result.disabled = { reason: item.disabled.reason };
			if (item.tags?.includes(ls.CodeActionTag.LLMGenerated)) result.isAI = true;
			return result;
		}
		function asCodeActionResult(items, token) {
			return async.mapAsync(items, async (item) => {
				if (ls.Command.is(item)) return asCommand(item);
				else return asCodeAction(item, token);
			}, token);
		}
		function asCodeLens(item) {
			if (!item) return;
			const result = new protocolCodeLens_1.default(asRange(item.range));
			if (item.command) result.command = asCommand(item.command);
			if (item.data !== void 0 && item.data !== null) result.data = item.data;
			return result;
		}
		async function asCodeLenses(items, token) {
			if (!items) return;
			return async.map(items, asCodeLens, token);
		}
		async function asWorkspaceEdit(item, token) {
			if (!item) return;
			const sharedMetadata = /* @__PURE__ */ new Map();
			if (item.changeAnnotations !== void 0) {
				const changeAnnotations = item.changeAnnotations;
				await async.forEach(Object.keys(changeAnnotations), (key) => {
					const metaData = asWorkspaceEditEntryMetadata(changeAnnotations[key]);
					sharedMetadata.set(key, metaData);
				}, token);
			}
			const asMetadata = (annotation) => {
				if (annotation === void 0) return;
				else return sharedMetadata.get(annotation);
			};
			const result = new code.WorkspaceEdit();
			if (item.documentChanges) {
				const documentChanges = item.documentChanges;
				await async.forEach(documentChanges, (change) => {
					if (ls.CreateFile.is(change)) result.createFile(_uriConverter(change.uri), change.options, asMetadata(change.annotationId));
					else if (ls.RenameFile.is(change)) result.renameFile(_uriConverter(change.oldUri), _uriConverter(change.newUri), change.options, asMetadata(change.annotationId));
					else if (ls.DeleteFile.is(change)) result.deleteFile(_uriConverter(change.uri), change.options, asMetadata(change.annotationId));
					else if (ls.TextDocumentEdit.is(change)) {
						const uri = _uriConverter(change.textDocument.uri);
						const edits = [];
						for (const edit of change.edits) if (ls.AnnotatedTextEdit.is(edit)) edits.push([new code.TextEdit(asRange(edit.range), edit.newText), asMetadata(edit.annotationId)]);
						else if (ls.SnippetTextEdit.is(edit)) edits.push([new code.SnippetTextEdit(asRange(edit.range), new code.SnippetString(edit.snippet.value)), asMetadata(edit.annotationId)]);
						else edits.push([new code.TextEdit(asRange(edit.range), edit.newText), void 0]);
						result.set(uri, edits);
					} else throw new Error(`Unknown workspace edit change received:\n${JSON.stringify(change, void 0, 4)}`);
				}, token);
			} else if (item.changes) {
				const changes = item.changes;
				await async.forEach(Object.keys(changes), (key) => {
					result.set(_uriConverter(key), asTextEditsSync(changes[key]));
				}, token);
			}
			return result;
		}
		function asWorkspaceEditEntryMetadata(annotation) {
			if (annotation === void 0) return;
			return {
				label: annotation.label,
				needsConfirmation: !!annotation.needsConfirmation,
				description: annotation.description
			};
		}
		function asDocumentLink(item) {
			const range = asRange(item.range);
			const target = item.target ? asUri(item.target) : void 0;
			const link = new protocolDocumentLink_1.default(range, target);
			if (item.tooltip !== void 0) link.tooltip = item.tooltip;
			if (item.data !== void 0 && item.data !== null) link.data = item.data;
			return link;
		}
		async function asDocumentLinks(items, token) {
			if (!items) return;
			return async.map(items, asDocumentLink, token);
		}
		function asColor(color) {
			return new code.Color(color.red, color.green, color.blue, color.alpha);
		}
		function asColorInformation(ci) {
			return new code.ColorInformation(asRange(ci.range), asColor(ci.color));
		}
		async function asColorInformations(colorInformation, token) {
			if (!colorInformation) return;
			return async.map(colorInformation, asColorInformation, token);
		}
		function asColorPresentation(cp) {
			const presentation = new code.ColorPresentation(cp.label);
			presentation.additionalTextEdits = asTextEditsSync(cp.additionalTextEdits);
			if (cp.textEdit) presentation.textEdit = asTextEdit(cp.textEdit);
			return presentation;
		}
		async function asColorPresentations(colorPresentations, token) {
			if (!colorPresentations) return;
			return async.map(colorPresentations, asColorPresentation, token);
		}
		function asFoldingRangeKind(kind) {
			if (kind) switch (kind) {
				case ls.FoldingRangeKind.Comment: return code.FoldingRangeKind.Comment;
				case ls.FoldingRangeKind.Imports: return code.FoldingRangeKind.Imports;
				case ls.FoldingRangeKind.Region: return code.FoldingRangeKind.Region;
			}
		}
		function asFoldingRange(r) {
			return new code.FoldingRange(r.startLine, r.endLine, asFoldingRangeKind(r.kind));
		}
		async function asFoldingRanges(foldingRanges, token) {
			if (!foldingRanges) return;
			return async.map(foldingRanges, asFoldingRange, token);
		}
		function asSelectionRange(selectionRange) {
			return new code.SelectionRange(asRange(selectionRange.range), selectionRange.parent ? asSelectionRange(selectionRange.parent) : void 0);
		}
		async function asSelectionRanges(selectionRanges, token) {
			if (!Array.isArray(selectionRanges)) return [];
			return async.map(selectionRanges, asSelectionRange, token);
		}
		function asInlineValue(inlineValue) {
			if (ls.InlineValueText.is(inlineValue)) return new code.InlineValueText(asRange(inlineValue.range), inlineValue.text);
			else if (ls.InlineValueVariableLookup.is(inlineValue)) return new code.InlineValueVariableLookup(asRange(inlineValue.range), inlineValue.variableName, inlineValue.caseSensitiveLookup);
			else return new code.InlineValueEvaluatableExpression(asRange(inlineValue.range), inlineValue.expression);
		}
		async function asInlineValues(inlineValues, token) {
			if (!Array.isArray(inlineValues)) return [];
			return async.map(inlineValues, asInlineValue, token);
		}
		async function asInlayHint(value, token) {
			const label = typeof value.label === "string" ? value.label : await async.map(value.label, asInlayHintLabelPart, token);
			const result = new protocolInlayHint_1.default(asPosition(value.position), label);
			if (value.kind !== void 0) result.kind = value.kind;
			if (value.textEdits !== void 0) result.textEdits = await asTextEdits(value.textEdits, token);
			if (value.tooltip !== void 0) result.tooltip = asTooltip(value.tooltip);
			if (value.paddingLeft !== void 0) result.paddingLeft = value.paddingLeft;
			if (value.paddingRight !== void 0) result.paddingRight = value.paddingRight;
			if (value.data !== void 0) result.data = value.data;
			return result;
		}
		function asInlayHintLabelPart(part) {
			const result = new code.InlayHintLabelPart(part.value);
			if (part.location !== void 0) result.location = asLocation(part.location);
			if (part.tooltip !== void 0) result.tooltip = asTooltip(part.tooltip);
			if (part.command !== void 0) result.command = asCommand(part.command);
			return result;
		}
		function asTooltip(value) {
			if (typeof value === "string") return value;
			return asMarkdownString(value);
		}
		async function asInlayHints(values, token) {
			if (!Array.isArray(values)) return;
			return async.mapAsync(values, asInlayHint, token);
		}
		function asCallHierarchyItem(item) {
			if (item === null) return;
			const result = new protocolCallHierarchyItem_1.default(asSymbolKind(item.kind), item.name, item.detail || "", asUri(item.uri), asRange(item.range), asRange(item.selectionRange), item.data);
			if (item.tags !== void 0) result.tags = asSymbolTags(item.tags);
			return result;
		}
		async function asCallHierarchyItems(items, token) {
			if (items === null) return;
			return async.map(items, asCallHierarchyItem, token);
		}
		async function asCallHierarchyIncomingCall(item, token) {
			return new code.CallHierarchyIncomingCall(asCallHierarchyItem(item.from), await asRanges(item.fromRanges, token));
		}
		async function asCallHierarchyIncomingCalls(items, token) {
			if (items === null) return;
			return async.mapAsync(items, asCallHierarchyIncomingCall, token);
		}
		async function asCallHierarchyOutgoingCall(item, token) {
			return new code.CallHierarchyOutgoingCall(asCallHierarchyItem(item.to), await asRanges(item.fromRanges, token));
		}
		async function asCallHierarchyOutgoingCalls(items, token) {
			if (items === null) return;
			return async.mapAsync(items, asCallHierarchyOutgoingCall, token);
		}
		async function asSemanticTokens(value, _token) {
			if (value === void 0 || value === null) return;
			return new code.SemanticTokens(new Uint32Array(value.data), value.resultId);
		}
		function asSemanticTokensEdit(value) {
			return new code.SemanticTokensEdit(value.start, value.deleteCount, value.data !== void 0 ? new Uint32Array(value.data) : void 0);
		}
		async function asSemanticTokensEdits(value, _token) {
			if (value === void 0 || value === null) return;
			return new code.SemanticTokensEdits(value.edits.map(asSemanticTokensEdit), value.resultId);
		}
		function asSemanticTokensLegend(value) {
			return value;
		}
		async function asLinkedEditingRanges(value, token) {
			if (value === null || value === void 0) return;
			return new code.LinkedEditingRanges(await asRanges(value.ranges, token), asRegularExpression(value.wordPattern));
		}
		function asRegularExpression(value) {
			if (value === null || value === void 0) return;
			return new RegExp(value);
		}
		function asTypeHierarchyItem(item) {
			if (item === null) return;
			const result = new protocolTypeHierarchyItem_1.default(asSymbolKind(item.kind), item.name, item.detail || "", asUri(item.uri), asRange(item.range), asRange(item.selectionRange), item.data);
			if (item.tags !== void 0) result.tags = asSymbolTags(item.tags);
			return result;
		}
		async function asTypeHierarchyItems(items, token) {
			if (items === null) return;
			return async.map(items, asTypeHierarchyItem, token);
		}
		function asGlobPattern(pattern) {
			if (Is.string(pattern)) return pattern;
			if (ls.RelativePattern.is(pattern)) {
				if (ls.URI.is(pattern.baseUri)) return new code.RelativePattern(asUri(pattern.baseUri), pattern.pattern);
				else if (ls.WorkspaceFolder.is(pattern.baseUri)) {
					const workspaceFolder = code.workspace.getWorkspaceFolder(asUri(pattern.baseUri.uri));
					return workspaceFolder !== void 0 ? new code.RelativePattern(workspaceFolder, pattern.pattern) : void 0;
				}
			}
		}
		async function asInlineCompletionResult(value, token) {
			if (!value) return;
			if (Array.isArray(value)) return async.map(value, (item) => asInlineCompletionItem(item), token);
			const list = value;
			const converted = await async.map(list.items, (item) => {
				return asInlineCompletionItem(item);
			}, token);
			return new code.InlineCompletionList(converted);
		}
		function asInlineCompletionItem(item) {
			let insertText;
			if (typeof item.insertText === "string") insertText = item.insertText;
			else insertText = new code.SnippetString(item.insertText.value);
			let command = void 0;
			if (item.command) command = asCommand(item.command);
			const inlineCompletionItem = new code.InlineCompletionItem(insertText, asRange(item.range), command);
			if (item.filterText) inlineCompletionItem.filterText = item.filterText;
			return inlineCompletionItem;
		}
		return {
			asUri,
			asDocumentSelector,
			asDiagnostics,
			asDiagnostic,
			asRange,
			asRanges,
			asPosition,
			asDiagnosticSeverity,
			asDiagnosticTag,
			asHover,
			asCompletionResult,
			asCompletionItem,
			asTextEdit,
			asTextEdits,
			asSignatureHelp,
			asSignatureInformations,
			asSignatureInformation,
			asParameterInformations,
			asParameterInformation,
			asDeclarationResult,
			asDefinitionResult,
			asLocation,
			asReferences,
			asDocumentHighlights,
			asDocumentHighlight,
			asDocumentHighlightKind,
			asSymbolKind,
			asSymbolTag,
			asSymbolTags,
			asSymbolInformations,
			asSymbolInformation,
			asDocumentSymbols,
			asDocumentSymbol,
			asCommand,
			asCommands,
			asCodeAction,
			asCodeActionKind,
			asCodeActionKinds,
			asCodeActionDocumentations,
			asCodeActionResult,
			asCodeLens,
			asCodeLenses,
			asWorkspaceEdit,
			asDocumentLink,
			asDocumentLinks,
			asFoldingRangeKind,
			asFoldingRange,
			asFoldingRanges,
			asColor,
			asColorInformation,
			asColorInformations,
			asColorPresentation,
			asColorPresentations,
			asSelectionRange,
			asSelectionRanges,
			asInlineValue,
			asInlineValues,
			asInlayHint,
			asInlayHints,
			asSemanticTokensLegend,
			asSemanticTokens,
			asSemanticTokensEdit,
			asSemanticTokensEdits,
			asCallHierarchyItem,
			asCallHierarchyItems,
			asCallHierarchyIncomingCall,
			asCallHierarchyIncomingCalls,
			asCallHierarchyOutgoingCall,
			asCallHierarchyOutgoingCalls,
			asLinkedEditingRanges,
			asTypeHierarchyItem,
			asTypeHierarchyItems,
			asGlobPattern,
			asInlineCompletionResult,
			asInlineCompletionItem
		};
	}
}));
// node_modules/vscode-languageclient/lib/common/progressPart.js
var require_progressPart = /* @__PURE__ */ __commonJSMin(((exports, module, this$16) => {
	var __createBinding = this$16 && this$16.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$16 && this$16.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$16 && this$16.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.ProgressPart = void 0;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var Is = __importStar(require_is$2());
	var ProgressPart = class {
		_client;
		_token;
		_infinite;
		_reported;
		_lspProgressDisposable;
		_progress;
		_cancellationToken;
		_tokenDisposable;
		_resolve;
		_reject;
		constructor(_client, _token, done) {
			this._client = _client;
			this._token = _token;
			this._reported = 0;
			this._infinite = false;
			this._lspProgressDisposable = this._client.onProgress(vscode_languageserver_protocol_1.WorkDoneProgress.type, this._token, (value) => {
				switch (value.kind) {
					case "begin":
						this.begin(value);
						break;
					case "report":
						this.report(value);
						break;
					case "end":
						this.done();
						done && done(this);
				}
			});
		}
		begin(params) {
			this._infinite = params.percentage === void 0;
			if (this._lspProgressDisposable === void 0) return;
			vscode_1.window.withProgress({
				location: vscode_1.ProgressLocation.Window,
				cancellable: params.cancellable,
				title: params.title
			}, async (progress, cancellationToken) => {
				if (this._lspProgressDisposable === void 0) return;
				this._progress = progress;
				this._cancellationToken = cancellationToken;
				this._tokenDisposable = this._cancellationToken.onCancellationRequested(() => {
					this._client.sendNotification(vscode_languageserver_protocol_1.WorkDoneProgressCancelNotification.type, { token: this._token });
				});
				this.report(params);
				return new Promise((resolve, reject) => {
					this._resolve = resolve;
					this._reject = reject;
				});
			});
		}
		report(params) {
			if (this._infinite && Is.string(params.message)) this._progress !== void 0 && this._progress.report({ message: params.message });
			else if (Is.number(params.percentage)) {
				const percentage = Math.max(0, Math.min(params.percentage, 100));
				const delta = Math.max(0, percentage - this._reported);
				this._reported += delta;
				this._progress !== void 0 && this._progress.report({
					message: params.message,
					increment: delta
				});
			}
		}
		cancel() {
			this.cleanup();
			if (this._reject !== void 0) {
				this._reject();
				this._resolve = void 0;
				this._reject = void 0;
			}
		}
		done() {
			this.cleanup();
			if (this._resolve !== void 0) {
				this._resolve();
				this._resolve = void 0;
				this._reject = void 0;
			}
		}
		cleanup() {
			if (this._lspProgressDisposable !== void 0) {
				this._lspProgressDisposable.dispose();
				this._lspProgressDisposable = void 0;
			}
			if (this._tokenDisposable !== void 0) {
				this._tokenDisposable.dispose();
				this._tokenDisposable = void 0;
			}
			this._progress = void 0;
			this._cancellationToken = void 0;
		}
	};
	exports.ProgressPart = ProgressPart;
}));
// node_modules/vscode-languageclient/lib/common/features.js
var require_features = /* @__PURE__ */ __commonJSMin(((exports, module, this$15) => {
	var __createBinding = this$15 && this$15.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$15 && this$15.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$15 && this$15.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.DefaultDiagnosticCollectionProvider = exports.DiagnosticCollectionSource = exports.WorkspaceFeature = exports.TextDocumentLanguageFeature = exports.TextDocumentEventFeature = exports.DynamicDocumentFeature = exports.DynamicFeature = exports.StaticFeature = exports.LSPCancellationError = void 0;
	exports.ensure = ensure;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var Is = __importStar(require_is$2());
	var LSPCancellationError = class extends vscode_1.CancellationError {
		data;
		constructor(data) {
			super();
			this.data = data;
		}
	};
	exports.LSPCancellationError = LSPCancellationError;
	function ensure(target, key) {
		if (target[key] === void 0) target[key] = {};
		return target[key];
	}
	var StaticFeature;
	(function(StaticFeature) {
		function is(value) {
			const candidate = value;
			return candidate !== void 0 && candidate !== null && Is.func(candidate.fillClientCapabilities) && Is.func(candidate.initialize) && Is.func(candidate.getState) && Is.func(candidate.clear) && (candidate.fillInitializeParams === void 0 || Is.func(candidate.fillInitializeParams));
		}
		StaticFeature.is = is;
	})(StaticFeature || (exports.StaticFeature = StaticFeature = {}));
	var DynamicFeature;
	(function(DynamicFeature) {
		function is(value) {
			const candidate = value;
			return candidate !== void 0 && candidate !== null && Is.func(candidate.fillClientCapabilities) && Is.func(candidate.initialize) && Is.func(candidate.getState) && Is.func(candidate.clear) && (candidate.fillInitializeParams === void 0 || Is.func(candidate.fillInitializeParams)) && Is.func(candidate.register) && Is.func(candidate.unregister) && candidate.registrationType !== void 0;
		}
		DynamicFeature.is = is;
	})(DynamicFeature || (exports.DynamicFeature = DynamicFeature = {}));
	/**
	* An abstract dynamic feature implementation that operates on documents (e.g. text
	* documents or notebooks).
	*/
	var DynamicDocumentFeature = class {
		_client;
		constructor(client) {
			this._client = client;
		}
		/**
		* Returns the state the feature is in.
		*/
		getState() {
			const selectors = this.getDocumentSelectors();
			let count = 0;
			for (const selector of selectors) {
				count++;
				for (const document of vscode_1.workspace.textDocuments) if (vscode_1.languages.match(selector, document) > 0) return {
					kind: "document",
					id: this.registrationType.method,
					registrations: true,
					matches: true
				};
			}
			const registrations = count > 0;
			return {
				kind: "document",
				id: this.registrationType.method,
				registrations,
				matches: false
			};
		}
	};
	exports.DynamicDocumentFeature = DynamicDocumentFeature;
	/**
	* An abstract base class to implement features that react to events
	* emitted from text documents.
	*/
	var TextDocumentEventFeature = class extends DynamicDocumentFeature {
		_event;
		_type;
		_middleware;
		_createParams;
		_textDocument;
		_selectorFilter;
		_listener;
		_selectors;
		_onAboutToSendNotification;
		_onNotificationSent;
		static textDocumentFilter(selectors, textDocument) {
			for (const selector of selectors) if (vscode_1.languages.match(selector, textDocument) > 0) return true;
			return false;
		}
		constructor(client, event, type, middleware, createParams, textDocument, selectorFilter) {
			super(client);
			this._event = event;
			this._type = type;
			this._middleware = middleware;
			this._createParams = createParams;
			this._textDocument = textDocument;
			this._selectorFilter = selectorFilter;
			this._selectors = /* @__PURE__ */ new Map();
			this._onAboutToSendNotification = new vscode_1.EventEmitter();
			this._onNotificationSent = new vscode_1.EventEmitter();
		}
		getStateInfo() {
			return [this._selectors.values(), false];
		}
		getDocumentSelectors() {
			return this._selectors.values();
		}
		register(data) {
			if (!data.registerOptions.documentSelector) return;
			if (!this._listener) this._listener = this._event((data) => {
				this.callback(data).catch((error) => {
					this._client.error(`Sending document notification ${this._type.method} failed.`, error);
				});
			});
			this._selectors.set(data.id, this._client.protocol2CodeConverter.asDocumentSelector(data.registerOptions.documentSelector));
		}
		async callback(data) {
			const doSend = async (data) => {
				const textDocument = this.getTextDocument(data);
				const params = this._createParams(data);
				this.aboutToSendNotification(textDocument, this._type, params);
				await this._client.sendNotification(this._type, params);
				this.notificationSent(textDocument, this._type, params);
			};
			if (this.matches(data)) {
				const middleware = this._middleware();
				return middleware ? middleware(data, (data) => doSend(data)) : doSend(data);
			}
		}
		matches(data) {
			if (this._client.hasDedicatedTextSynchronizationFeature(this._textDocument(data))) return false;
			return !this._selectorFilter || this._selectorFilter(this._selectors.values(), data);
		}
		get onAboutToSendNotification() {
			return this._onAboutToSendNotification.event;
		}
		aboutToSendNotification(textDocument, type, params) {
			this._onAboutToSendNotification.fire({
				textDocument,
				type,
				params
			});
		}
		get onNotificationSent() {
			return this._onNotificationSent.event;
		}
		notificationSent(textDocument, type, params) {
			this._onNotificationSent.fire({
				textDocument,
				type,
				params
			});
		}
		unregister(id) {
			this._selectors.delete(id);
			if (this._selectors.size === 0 && this._listener) {
				this._listener.dispose();
				this._listener = void 0;
			}
		}
		clear() {
			this._selectors.clear();
			this._onNotificationSent.dispose();
			this._onNotificationSent = new vscode_1.EventEmitter();
			if (this._listener) {
				this._listener.dispose();
				this._listener = void 0;
			}
		}
		getProvider(document) {
			for (const selector of this._selectors.values()) if (vscode_1.languages.match(selector, document) > 0) return { send: (data) => {
				return this.callback(data);
			} };
		}
	};
	exports.TextDocumentEventFeature = TextDocumentEventFeature;
	/**
	* A abstract feature implementation that registers language providers
	* for text documents using a given document selector.
	*/
	var TextDocumentLanguageFeature = class extends DynamicDocumentFeature {
		_registrationType;
		_registrations;
		constructor(client, registrationType) {
			super(client);
			this._registrationType = registrationType;
			this._registrations = /* @__PURE__ */ new Map();
		}
		*getDocumentSelectors() {
			for (const registration of this._registrations.values()) {
				const selector = registration.data.registerOptions.documentSelector;
				if (selector === null) continue;
				yield this._client.protocol2CodeConverter.asDocumentSelector(selector);
			}
		}
		get registrationType() {
			return this._registrationType;
		}
		register(data) {
			if (!data.registerOptions.documentSelector) return;
			const registration = this.registerLanguageProvider(data.registerOptions, data.id);
			this._registrations.set(data.id, {
				disposable: registration[0],
				data,
				provider: registration[1]
			});
		}
		unregister(id) {
			const registration = this._registrations.get(id);
			if (registration !== void 0) {
				this._registrations.delete(id);
				registration.disposable.dispose();
			}
		}
		clear() {
			this._registrations.forEach((value) => {
				value.disposable.dispose();
			});
			this._registrations.clear();
		}
		getRegistration(documentSelector, capability) {
			if (!capability) return [void 0, void 0];
			else if (vscode_languageserver_protocol_1.TextDocumentRegistrationOptions.is(capability)) {
				const id = vscode_languageserver_protocol_1.StaticRegistrationOptions.hasId(capability) ? capability.id : (0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID();
				const selector = capability.documentSelector ?? documentSelector;
				if (selector) return [id, Object.assign({}, capability, { documentSelector: selector })];
			} else if (Is.boolean(capability) && capability === true || vscode_languageserver_protocol_1.WorkDoneProgressOptions.is(capability)) {
				if (!documentSelector) return [void 0, void 0];
				const options = Is.boolean(capability) && capability === true ? { documentSelector } : Object.assign({}, capability, { documentSelector });
				return [(0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID(), options];
			}
			return [void 0, void 0];
		}
		getRegistrationOptions(documentSelector, capability) {
			if (!documentSelector || !capability) return;
			return Is.boolean(capability) && capability === true ? { documentSelector } : Object.assign({}, capability, { documentSelector });
		}
		getProvider(textDocument) {
			for (const registration of this._registrations.values()) {
				const selector = registration.data.registerOptions.documentSelector;
				if (selector !== null && vscode_1.languages.match(this._client.protocol2CodeConverter.asDocumentSelector(selector), textDocument) > 0) return registration.provider;
			}
		}
		getAllProviders() {
			const result = [];
			for (const item of this._registrations.values()) result.push(item.provider);
			return result;
		}
	};
	exports.TextDocumentLanguageFeature = TextDocumentLanguageFeature;
	var WorkspaceFeature = class {
		_client;
		_registrationType;
		_registrations;
		constructor(client, registrationType) {
			this._client = client;
			this._registrationType = registrationType;
			this._registrations = /* @__PURE__ */ new Map();
		}
		getState() {
			const registrations = this._registrations.size > 0;
			return {
				kind: "workspace",
				id: this._registrationType.method,
				registrations
			};
		}
		get registrationType() {
			return this._registrationType;
		}
		register(data) {
			const registration = this.registerLanguageProvider(data.registerOptions);
			this._registrations.set(data.id, {
				disposable: registration[0],
				provider: registration[1]
			});
		}
		unregister(id) {
			const registration = this._registrations.get(id);
			if (registration !== void 0) {
				this._registrations.delete(id);
				registration.disposable.dispose();
			}
		}
		clear() {
			this._registrations.forEach((registration) => {
				registration.disposable.dispose();
			});
			this._registrations.clear();
		}
		getProviders() {
			const result = [];
			for (const registration of this._registrations.values()) result.push(registration.provider);
			return result;
		}
	};
	exports.WorkspaceFeature = WorkspaceFeature;
	var DiagnosticCollectionSource;
	(function(DiagnosticCollectionSource) {
		DiagnosticCollectionSource["push"] = "push";
		DiagnosticCollectionSource["pull"] = "pull";
	})(DiagnosticCollectionSource || (exports.DiagnosticCollectionSource = DiagnosticCollectionSource = {}));
	/**
	* The default {@link DiagnosticCollectionProvider}. It never shares a diagnostic
	* collection between the push and the pull model. Every call to {@link create}
	* returns a new collection and {@link dispose} disposes it directly.
	*/
	var DefaultDiagnosticCollectionProvider = class {
		create(name, _source) {
			return name !== void 0 ? vscode_1.languages.createDiagnosticCollection(name) : vscode_1.languages.createDiagnosticCollection();
		}
		dispose(collection, _source) {
			collection.dispose();
		}
	};
	exports.DefaultDiagnosticCollectionProvider = DefaultDiagnosticCollectionProvider;
}));
// node_modules/balanced-match/dist/commonjs/index.js
var require_commonjs$2 = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.range = exports.balanced = void 0;
	var balanced = (a, b, str) => {
		const ma = a instanceof RegExp ? maybeMatch(a, str) : a;
		const mb = b instanceof RegExp ? maybeMatch(b, str) : b;
		const r = ma !== null && mb != null && (0, exports.range)(ma, mb, str);
		return r && {
			start: r[0],
			end: r[1],
			pre: str.slice(0, r[0]),
			body: str.slice(r[0] + ma.length, r[1]),
			post: str.slice(r[1] + mb.length)
		};
	};
	exports.balanced = balanced;
	var maybeMatch = (reg, str) => {
		const m = str.match(reg);
		return m ? m[0] : null;
	};
	var range = (a, b, str) => {
		let begs, beg, left, right = void 0, result;
		let ai = str.indexOf(a);
		let bi = str.indexOf(b, ai + 1);
		let i = ai;
		if (ai >= 0 && bi > 0) {
			if (a === b) return [ai, bi];
			begs = [];
			left = str.length;
			while (i >= 0 && !result) {
				if (i === ai) {
					begs.push(i);
					ai = str.indexOf(a, i + 1);
				} else if (begs.length === 1) {
					const r = begs.pop();
					if (r !== void 0) result = [r, bi];
				} else {
					beg = begs.pop();
					if (beg !== void 0 && beg < left) {
						left = beg;
						right = bi;
					}
					bi = str.indexOf(b, i + 1);
				}
				i = ai < bi && ai >= 0 ? ai : bi;
			}
			if (begs.length && right !== void 0) result = [left, right];
		}
		return result;
	};
	exports.range = range;
}));
// node_modules/brace-expansion/dist/commonjs/index.js
var require_commonjs$1 = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.EXPANSION_MAX_STEPS = exports.EXPANSION_MAX_REWRITES = exports.EXPANSION_MAX_DEPTH = exports.EXPANSION_MAX_LENGTH = exports.EXPANSION_MAX = void 0;
	exports.expand = expand;
	var balanced_match_1 = require_commonjs$2();
	var escSlash = "\0SLASH" + Math.random().toFixed(16) + "\0";
	var escOpen = "\0OPEN" + Math.random().toFixed(16) + "\0";
	var escClose = "\0CLOSE" + Math.random().toFixed(16) + "\0";
	var escComma = "\0COMMA" + Math.random().toFixed(16) + "\0";
	var escPeriod = "\0PERIOD" + Math.random().toFixed(16) + "\0";
	var escSlashPattern = new RegExp(escSlash, "g");
	var escOpenPattern = new RegExp(escOpen, "g");
	var escClosePattern = new RegExp(escClose, "g");
	var escCommaPattern = new RegExp(escComma, "g");
	var escPeriodPattern = new RegExp(escPeriod, "g");
	var slashPattern = /\\\\/g;
	var openPattern = /\\{/g;
	var closePattern = /\\}/g;
	var commaPattern = /\\,/g;
	var periodPattern = /\\\./g;
	exports.EXPANSION_MAX = 1e5;
	exports.EXPANSION_MAX_LENGTH = 4e6;
	exports.EXPANSION_MAX_DEPTH = 1e3;
	exports.EXPANSION_MAX_REWRITES = 1e3;
	exports.EXPANSION_MAX_STEPS = 2e7;
	var CALL_STEPS = 16;
	function numeric(str) {
		return !isNaN(str) ? parseInt(str, 10) : str.charCodeAt(0);
	}
	function escapeBraces(str) {
		return str.replace(slashPattern, escSlash).replace(openPattern, escOpen).replace(closePattern, escClose).replace(commaPattern, escComma).replace(periodPattern, escPeriod);
	}
	function unescapeBraces(str) {
		return str.replace(escSlashPattern, "\\").replace(escOpenPattern, "{").replace(escClosePattern, "}").replace(escCommaPattern, ",").replace(escPeriodPattern, ".");
	}
	function pushAll(target, items) {
		for (let i = 0; i < items.length; i++) target.push(items[i]);
	}
	function balancedWithBudget(str, masked, budget) {
		if (budget.remaining < 0) return;
		const r = (0, balanced_match_1.range)("{", "}", masked);
		const unmatched = r !== void 0 && masked.indexOf("{") < r[0];
		budget.remaining -= r && !unmatched ? r[1] + 1 : str.length;
		if (!r || budget.remaining < 0) return;
		return {
			end: r[1],
			pre: str.slice(0, r[0]),
			body: str.slice(r[0] + 1, r[1]),
			post: str.slice(r[1] + 1),
			unmatched
		};
	}
	function maskUnmatchedOpens(masked, budget) {
		budget.remaining -= masked.length;
		const open = [];
		for (let i = 0; i < masked.length; i++) {
			const c = masked.charCodeAt(i);
			if (c === 123) open.push(i);
			else if (c === 125 && open.length) open.pop();
		}
		let out = "";
		let last = 0;
		for (let i = 0; i < open.length; i++) {
			const at = open[i];
			out += masked.slice(last, at) + "\0";
			last = at + 1;
		}
		return out + masked.slice(last);
	}
	function commaSetFollows(str, budget) {
		budget.remaining -= str.length;
		if (budget.remaining < 0) return false;
		let close = false;
		for (let i = str.length - 1; i >= 0; i--) {
			const c = str.charCodeAt(i);
			if (c === 125) close = true;
			else if (c === 10 || c === 13 || c === 8232 || c === 8233) close = false;
			else if (c === 44 && close && str.charCodeAt(i + 1) !== 44) return true;
		}
		return false;
	}
	/**
	* Basically just str.split(","), but handling cases
	* where we have nested braced sections, which should be
	* treated as individual members, like {a,{b,c},d}
	*
	* Returns `undefined` if the step budget runs out before the whole set is
	* split, since splitting what is left on every comma would tear apart the
	* nested sets it still holds.
	*/
	function parseCommaParts(str, budget) {
		const parts = [];
		let carry = "";
		for (;;) {
			const m = balancedWithBudget(str, str, budget);
			if (budget.remaining < 0) return;
			if (!m) {
				const tail = str.split(",");
				tail[0] = carry + tail[0];
				pushAll(parts, tail);
				return parts;
			}
			const { pre, body, post } = m;
			const p = pre.split(",");
			p[0] = carry + p[0];
			p[p.length - 1] += "{" + body + "}";
			if (!post.length) {
				pushAll(parts, p);
				return parts;
			}
			carry = p.pop();
			pushAll(parts, p);
			str = post;
		}
	}
	function bound(value, fallback) {
		return value === void 0 || isNaN(value) ? fallback : value;
	}
	function expand(str, options = {}) {
		if (!str) return [];
		const max = bound(options.max, exports.EXPANSION_MAX);
		const maxLength = bound(options.maxLength, exports.EXPANSION_MAX_LENGTH);
		const maxDepth = bound(options.maxDepth, exports.EXPANSION_MAX_DEPTH);
		const maxRewrites = bound(options.maxRewrites, exports.EXPANSION_MAX_REWRITES);
		const maxSteps = bound(options.maxSteps, exports.EXPANSION_MAX_STEPS);
		if (str.slice(0, 2) === "{}") str = "\\{\\}" + str.slice(2);
		return expand_(escapeBraces(str), max, maxLength, maxDepth, 0, maxRewrites, { remaining: maxSteps }, true).map(unescapeBraces);
	}
	function embrace(str) {
		return "{" + str + "}";
	}
	function isPadded(el) {
		return /^-?0\d/.test(el);
	}
	function lte(i, y) {
		return i <= y;
	}
	function gte(i, y) {
		return i >= y;
	}
	function combine(acc, pre, values, max, maxLength, dropEmpties, budget) {
		const out = [];
		let length = 0;
		let nonEmpty;
		outer: for (let a = 0; a < acc.length; a++) {
			const prefix = acc[a] + pre;
			let vs = values;
			if (dropEmpties && !prefix) {
				if (!nonEmpty) nonEmpty = values.filter((v) => v);
				vs = nonEmpty;
			}
			for (let v = 0; v < vs.length; v++) {
				if (out.length >= max) break outer;
				const expansion = prefix + vs[v];
				if (length + expansion.length > maxLength) break outer;
				out.push(expansion);
				length += expansion.length;
			}
		}
		budget.remaining -= out.length;
		return out;
	}
	function expandSequence(body, isAlphaSequence, max, maxLength, budget) {
		const n = body.split(/\.\./);
		const N = [];
		/* c8 ignore start */
		if (n[0] === void 0 || n[1] === void 0) return N;
		/* c8 ignore stop */
		const x = numeric(n[0]);
		const y = numeric(n[1]);
		const width = Math.max(n[0].length, n[1].length);
		let incr = n.length === 3 && n[2] !== void 0 ? Math.max(Math.abs(numeric(n[2])), 1) : 1;
		let test = lte;
		if (y < x) {
			incr *= -1;
			test = gte;
		}
		const pad = n.some(isPadded);
		const cost = pad ? width : 1;
		let length = 0;
		for (let i = x; test(i, y) && N.length < max; i += incr) {
			budget.remaining -= cost;
			if (budget.remaining < 0) return;
			let c;
			if (isAlphaSequence) {
				c = String.fromCharCode(i);
				if (c === "\\") c = "";
			} else {
				c = String(i);
				if (pad) {
					const need = width - c.length;
					if (need > 0) {
						const z = new Array(need + 1).join("0");
						if (i < 0) c = "-" + z + c.slice(1);
						else c = z + c;
					}
				}
			}
			if (length + c.length > maxLength) break;
			N.push(c);
			length += c.length;
		}
		return N;
	}
	function expand_(str, max, maxLength, maxDepth, depth, maxRewrites, budget, isTop) {
		budget.remaining -= CALL_STEPS;
		if (depth > maxDepth) return [str];
		let acc = [""];
		let rewrites = 0;
		let dropEmpties = false;
		let firstGroup = true;
		let masked = str;
		for (;;) {
			const m = balancedWithBudget(str, masked, budget);
			if (!m) return combine(acc, str, [""], max, maxLength, dropEmpties, budget);
			if (m.unmatched) masked = maskUnmatchedOpens(masked, budget);
			const pre = m.pre;
			const literal = () => combine(acc, pre + "{" + m.body + "}" + m.post, [""], max, maxLength, dropEmpties, budget);
			if (/\$$/.test(pre)) {
				acc = combine(acc, pre + "{" + m.body + "}", [""], max, maxLength, dropEmpties && !m.post.length, budget);
				firstGroup = false;
				if (!m.post.length) break;
				str = m.post;
				masked = masked.slice(m.end + 1);
				continue;
			}
			const isNumericSequence = /^-?\d+\.\.-?\d+(?:\.\.-?\d+)?$/.test(m.body);
			const isAlphaSequence = /^[a-zA-Z]\.\.[a-zA-Z](?:\.\.-?\d+)?$/.test(m.body);
			const isSequence = isNumericSequence || isAlphaSequence;
			const isOptions = m.body.indexOf(",") >= 0;
			if (!isSequence && !isOptions) {
				if (rewrites < maxRewrites && commaSetFollows(m.post, budget)) {
					rewrites++;
					str = m.pre + "{" + m.body + escClose + m.post;
					masked = masked.slice(0, m.end) + escClose + masked.slice(m.end + 1);
					isTop = true;
					continue;
				}
				return literal();
			}
			if (firstGroup) {
				dropEmpties = isTop && !isSequence;
				firstGroup = false;
			}
			let values;
			if (isSequence) {
				values = expandSequence(m.body, isAlphaSequence, max, maxLength, budget);
				if (!values) return literal();
			} else {
				let n = parseCommaParts(m.body, budget);
				if (!n) return literal();
				if (n.length === 1 && n[0] !== void 0) {
					n = expand_(n[0], max, maxLength, maxDepth, depth + 1, maxRewrites, budget, false).map(embrace);
					if (budget.remaining < 0) return literal();
					/* c8 ignore start */
					if (n.length === 1) {
						const next = combine(acc, pre + n[0], [""], max, maxLength, dropEmpties && !m.post.length, budget);
						if (budget.remaining < 0) return literal();
						acc = next;
						if (!m.post.length) break;
						str = m.post;
						masked = masked.slice(m.end + 1);
						continue;
					}
				}
				let dropsEmpties = dropEmpties && !m.post.length && !pre;
				for (let d = 0; dropsEmpties && d < acc.length; d++) if (acc[d]) dropsEmpties = false;
				values = [];
				let valuesLength = 0;
				outer: for (let j = 0; j < n.length; j++) {
					const expanded = expand_(n[j], max, maxLength, maxDepth, depth + 1, maxRewrites, budget, false);
					if (budget.remaining < 0) return literal();
					for (let k = 0; k < expanded.length; k++) {
						const v = expanded[k];
						if (dropsEmpties && !v) continue;
						if (values.length >= max || valuesLength + v.length > maxLength) break outer;
						values.push(v);
						valuesLength += v.length;
					}
				}
			}
			const next = combine(acc, pre, values, max, maxLength, dropEmpties && !m.post.length, budget);
			if (budget.remaining < 0) return literal();
			acc = next;
			if (!m.post.length) break;
			str = m.post;
			masked = masked.slice(m.end + 1);
		}
		return acc;
	}
}));
// node_modules/minimatch/dist/commonjs/assert-valid-pattern.js
var require_assert_valid_pattern = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.assertValidPattern = void 0;
	var MAX_PATTERN_LENGTH = 65536;
	var assertValidPattern = (pattern) => {
		if (typeof pattern !== "string") throw new TypeError("invalid pattern");
		if (pattern.length > MAX_PATTERN_LENGTH) throw new TypeError("pattern is too long");
	};
	exports.assertValidPattern = assertValidPattern;
}));
// node_modules/minimatch/dist/commonjs/brace-expressions.js
var require_brace_expressions = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.parseClass = void 0;
	var posixClasses = {
		"[:alnum:]": ["\\p{L}\\p{Nl}\\p{Nd}", true],
		"[:alpha:]": ["\\p{L}\\p{Nl}", true],
		"[:ascii:]": ["\\x00-\\x7f", false],
		"[:blank:]": ["\\p{Zs}\\t", true],
		"[:cntrl:]": ["\\p{Cc}", true],
		"[:digit:]": ["\\p{Nd}", true],
		"[:graph:]": [
			"\\p{Z}\\p{C}",
			true,
			true
		],
		"[:lower:]": ["\\p{Ll}", true],
		"[:print:]": ["\\p{C}", true],
		"[:punct:]": ["\\p{P}", true],
		"[:space:]": ["\\p{Z}\\t\\r\\n\\v\\f", true],
		"[:upper:]": ["\\p{Lu}", true],
		"[:word:]": ["\\p{L}\\p{Nl}\\p{Nd}\\p{Pc}", true],
		"[:xdigit:]": ["A-Fa-f0-9", false]
	};
	var braceEscape = (s) => s.replace(/[[\]\\-]/g, "\\$&");
	var regexpEscape = (s) => s.replace(/[-[\]{}()*+?.,\\^$|#\s]/g, "\\$&");
	var rangesToString = (ranges) => ranges.join("");
	var parseClass = (glob, position) => {
		const pos = position;
		/* c8 ignore start */
		if (glob.charAt(pos) !== "[") throw new Error("not in a brace expression");
		/* c8 ignore stop */
		const ranges = [];
		const negs = [];
		let i = pos + 1;
		let sawStart = false;
		let uflag = false;
		let escaping = false;
		let negate = false;
		let endPos = pos;
		let rangeStart = "";
		WHILE: while (i < glob.length) {
			const c = glob.charAt(i);
			if ((c === "!" || c === "^") && i === pos + 1) {
				negate = true;
				i++;
				continue;
			}
			if (c === "]" && sawStart && !escaping) {
				endPos = i + 1;
				break;
			}
			sawStart = true;
			if (c === "\\") {
				if (!escaping) {
					escaping = true;
					i++;
					continue;
				}
			}
			if (c === "[" && !escaping) {
				for (const [cls, [unip, u, neg]] of Object.entries(posixClasses)) if (glob.startsWith(cls, i)) {
					if (rangeStart) return [
						"$.",
						false,
						glob.length - pos,
						true
					];
					i += cls.length;
					if (neg) negs.push(unip);
					else ranges.push(unip);
					uflag = uflag || u;
					continue WHILE;
				}
			}
			escaping = false;
			if (rangeStart) {
				if (c > rangeStart) ranges.push(braceEscape(rangeStart) + "-" + braceEscape(c));
				else if (c === rangeStart) ranges.push(braceEscape(c));
				rangeStart = "";
				i++;
				continue;
			}
			if (glob.startsWith("-]", i + 1)) {
				ranges.push(braceEscape(c + "-"));
				i += 2;
				continue;
			}
			if (glob.startsWith("-", i + 1)) {
				rangeStart = c;
				i += 2;
				continue;
			}
			ranges.push(braceEscape(c));
			i++;
		}
		if (endPos < i) return [
			"",
			false,
			0,
			false
		];
		if (!ranges.length && !negs.length) return [
			"$.",
			false,
			glob.length - pos,
			true
		];
		if (negs.length === 0 && ranges.length === 1 && /^\\?.$/.test(ranges[0]) && !negate) return [
			regexpEscape(ranges[0].length === 2 ? ranges[0].slice(-1) : ranges[0]),
			false,
			endPos - pos,
			false
		];
		const sranges = "[" + (negate ? "^" : "") + rangesToString(ranges) + "]";
		const snegs = "[" + (negate ? "" : "^") + rangesToString(negs) + "]";
		return [
			ranges.length && negs.length ? "(" + sranges + "|" + snegs + ")" : ranges.length ? sranges : snegs,
			uflag,
			endPos - pos,
			true
		];
	};
	exports.parseClass = parseClass;
}));
// node_modules/minimatch/dist/commonjs/unescape.js
var require_unescape = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.unescape = void 0;
	/**
	* Un-escape a string that has been escaped with {@link escape}.
	*
	* If the {@link MinimatchOptions.windowsPathsNoEscape} option is used, then
	* square-bracket escapes are removed, but not backslash escapes.
	*
	* For example, it will turn the string `'[*]'` into `*`, but it will not
	* turn `'\\*'` into `'*'`, because `\` is a path separator in
	* `windowsPathsNoEscape` mode.
	*
	* When `windowsPathsNoEscape` is not set, then both square-bracket escapes and
	* backslash escapes are removed.
	*
	* Slashes (and backslashes in `windowsPathsNoEscape` mode) cannot be escaped
	* or unescaped.
	*
	* When `magicalBraces` is not set, escapes of braces (`{` and `}`) will not be
	* unescaped.
	*/
	var unescape = (s, { windowsPathsNoEscape = false, magicalBraces = true } = {}) => {
		if (magicalBraces) return windowsPathsNoEscape ? s.replace(/\[([^/\\])\]/g, "$1") : s.replace(/((?!\\).|^)\[([^/\\])\]/g, "$1$2").replace(/\\([^/])/g, "$1");
		return windowsPathsNoEscape ? s.replace(/\[([^/\\{}])\]/g, "$1") : s.replace(/((?!\\).|^)\[([^/\\{}])\]/g, "$1$2").replace(/\\([^/{}])/g, "$1");
	};
	exports.unescape = unescape;
}));
// node_modules/minimatch/dist/commonjs/ast.js
var require_ast = /* @__PURE__ */ __commonJSMin(((exports) => {
	var _a;
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.AST = void 0;
	var brace_expressions_js_1 = require_brace_expressions();
	var unescape_js_1 = require_unescape();
	var types = /* @__PURE__ */ new Set([
		"!",
		"?",
		"+",
		"*",
		"@"
	]);
	var isExtglobType = (c) => types.has(c);
	var isExtglobAST = (c) => isExtglobType(c.type);
	var adoptionMap = /* @__PURE__ */ new Map([
		["!", ["@"]],
		["?", ["?", "@"]],
		["@", ["@"]],
		["*", [
			"*",
			"+",
			"?",
			"@"
		]],
		["+", ["+", "@"]]
	]);
	var adoptionWithSpaceMap = /* @__PURE__ */ new Map([
		["!", ["?"]],
		["@", ["?"]],
		["+", ["?", "*"]]
	]);
	var adoptionAnyMap = /* @__PURE__ */ new Map([
		["!", ["?", "@"]],
		["?", ["?", "@"]],
		["@", ["?", "@"]],
		["*", [
			"*",
			"+",
			"?",
			"@"
		]],
		["+", [
			"+",
			"@",
			"?",
			"*"
		]]
	]);
	var usurpMap = /* @__PURE__ */ new Map([
		["!", /* @__PURE__ */ new Map([["!", "@"]])],
		["?", /* @__PURE__ */ new Map([["*", "*"], ["+", "*"]])],
		["@", /* @__PURE__ */ new Map([
			["!", "!"],
			["?", "?"],
			["@", "@"],
			["*", "*"],
			["+", "+"]
		])],
		["+", /* @__PURE__ */ new Map([["?", "*"], ["*", "*"]])]
	]);
	var startNoTraversal = "(?!(?:^|/)\\.\\.?(?:$|/))";
	var startNoDot = "(?!\\.)";
	var addPatternStart = /* @__PURE__ */ new Set(["[", "."]);
	var justDots = /* @__PURE__ */ new Set(["..", "."]);
	var reSpecials = /* @__PURE__ */ new Set("().*{}+?[]^$\\!");
	var regExpEscape = (s) => s.replace(/[-[\]{}()*+?.,\\^$|#\s]/g, "\\$&");
	var qmark = "[^/]";
	var star = "[^/]*?";
	var starNoEmpty = "[^/]+?";
	var ID = 0;
	var AST = class {
		type;
		#root;
		#hasMagic;
		#uflag = false;
		#parts = [];
		#parent;
		#parentIndex;
		#negs;
		#filledNegs = false;
		#options;
		#toString;
		#emptyExt = false;
		id = ++ID;
		get depth() {
			return (this.#parent?.depth ?? -1) + 1;
		}
		[Symbol.for("nodejs.util.inspect.custom")]() {
			return {
				"@@type": "AST",
				id: this.id,
				type: this.type,
				root: this.#root.id,
				parent: this.#parent?.id,
				depth: this.depth,
				partsLength: this.#parts.length,
				parts: this.#parts
			};
		}
		constructor(type, parent, options = {}) {
			this.type = type;
			if (type) this.#hasMagic = true;
			this.#parent = parent;
			this.#root = this.#parent ? this.#parent.#root : this;
			this.#options = this.#root === this ? options : this.#root.#options;
			this.#negs = this.#root === this ? [] : this.#root.#negs;
			if (type === "!" && !this.#root.#filledNegs) this.#negs.push(this);
			this.#parentIndex = this.#parent ? this.#parent.#parts.length : 0;
		}
		get hasMagic() {
			/* c8 ignore start */
			if (this.#hasMagic !== void 0) return this.#hasMagic;
			/* c8 ignore stop */
			for (const p of this.#parts) {
				if (typeof p === "string") continue;
				if (p.type || p.hasMagic) return this.#hasMagic = true;
			}
			return this.#hasMagic;
		}
		toString() {
			return this.#toString !== void 0 ? this.#toString : !this.type ? this.#toString = this.#parts.map((p) => String(p)).join("") : this.#toString = this.type + "(" + this.#parts.map((p) => String(p)).join("|") + ")";
		}
		#fillNegs() {
			/* c8 ignore start */
			if (this !== this.#root) throw new Error("should only call on root");
			if (this.#filledNegs) return this;
			/* c8 ignore stop */
			this.toString();
			this.#filledNegs = true;
			let n;
			while (n = this.#negs.pop()) {
				if (n.type !== "!") continue;
				let p = n;
				let pp = p.#parent;
				while (pp) {
					for (let i = p.#parentIndex + 1; !pp.type && i < pp.#parts.length; i++) for (const part of n.#parts) {
						/* c8 ignore start */
						if (typeof part === "string") throw new Error("string part in extglob AST??");
						/* c8 ignore stop */
						part.copyIn(pp.#parts[i]);
					}
					p = pp;
					pp = p.#parent;
				}
			}
			return this;
		}
		push(...parts) {
			for (const p of parts) {
				if (p === "") continue;
				/* c8 ignore start */
				if (typeof p !== "string" && !(p instanceof _a && p.#parent === this)) throw new Error("invalid part: " + p);
				/* c8 ignore stop */
				this.#parts.push(p);
			}
		}
		toJSON() {
			const ret = this.type === null ? this.#parts.slice().map((p) => typeof p === "string" ? p : p.toJSON()) : [this.type, ...this.#parts.map((p) => p.toJSON())];
			if (this.isStart() && !this.type) ret.unshift([]);
			if (this.isEnd() && (this === this.#root || this.#root.#filledNegs && this.#parent?.type === "!")) ret.push({});
			return ret;
		}
		isStart() {
			if (this.#root === this) return true;
			if (!this.#parent?.isStart()) return false;
			if (this.#parentIndex === 0) return true;
			const p = this.#parent;
			for (let i = 0; i < this.#parentIndex; i++) {
				const pp = p.#parts[i];
				if (!(pp instanceof _a && pp.type === "!")) return false;
			}
			return true;
		}
		isEnd() {
			if (this.#root === this) return true;
			if (this.#parent?.type === "!") return true;
			if (!this.#parent?.isEnd()) return false;
			if (!this.type) return this.#parent?.isEnd();
			/* c8 ignore start */
			const pl = this.#parent ? this.#parent.#parts.length : 0;
			/* c8 ignore stop */
			return this.#parentIndex === pl - 1;
		}
		copyIn(part) {
			if (typeof part === "string") this.push(part);
			else this.push(part.clone(this));
		}
		clone(parent) {
			const c = new _a(this.type, parent);
			for (const p of this.#parts) c.copyIn(p);
			return c;
		}
		static #parseAST(str, ast, pos, opt, extDepth) {
			const maxDepth = opt.maxExtglobRecursion ?? 2;
			let escaping = false;
			let inBrace = false;
			let braceStart = -1;
			let braceNeg = false;
			if (ast.type === null) {
				let i = pos;
				let acc = "";
				while (i < str.length) {
					const c = str.charAt(i++);
					if (escaping || c === "\\") {
						escaping = !escaping;
						acc += c;
						continue;
					}
					if (inBrace) {
						if (i === braceStart + 1) {
							if (c === "^" || c === "!") braceNeg = true;
						} else if (c === "]" && !(i === braceStart + 2 && braceNeg)) inBrace = false;
						acc += c;
						continue;
					} else if (c === "[") {
						inBrace = true;
						braceStart = i;
						braceNeg = false;
						acc += c;
						continue;
					}
					if (!opt.noext && isExtglobType(c) && str.charAt(i) === "(" && extDepth <= maxDepth) {
						ast.push(acc);
						acc = "";
						const ext = new _a(c, ast);
						i = _a.#parseAST(str, ext, i, opt, extDepth + 1);
						ast.push(ext);
						continue;
					}
					acc += c;
				}
				ast.push(acc);
				return i;
			}
			let i = pos + 1;
			let part = new _a(null, ast);
			const parts = [];
			let acc = "";
			while (i < str.length) {
				const c = str.charAt(i++);
				if (escaping || c === "\\") {
					escaping = !escaping;
					acc += c;
					continue;
				}
				if (inBrace) {
					if (i === braceStart + 1) {
						if (c === "^" || c === "!") braceNeg = true;
					} else if (c === "]" && !(i === braceStart + 2 && braceNeg)) inBrace = false;
					acc += c;
					continue;
				} else if (c === "[") {
					inBrace = true;
					braceStart = i;
					braceNeg = false;
					acc += c;
					continue;
				}
				/* c8 ignore stop */
				if (!opt.noext && isExtglobType(c) && str.charAt(i) === "(" && (extDepth <= maxDepth || ast && ast.#canAdoptType(c))) {
					const depthAdd = ast && ast.#canAdoptType(c) ? 0 : 1;
					part.push(acc);
					acc = "";
					const ext = new _a(c, part);
					part.push(ext);
					i = _a.#parseAST(str, ext, i, opt, extDepth + depthAdd);
					continue;
				}
				if (c === "|") {
					part.push(acc);
					acc = "";
					parts.push(part);
					part = new _a(null, ast);
					continue;
				}
				if (c === ")") {
					if (acc === "" && ast.#parts.length === 0) ast.#emptyExt = true;
					part.push(acc);
					acc = "";
					ast.push(...parts, part);
					return i;
				}
				acc += c;
			}
			ast.type = null;
			ast.#hasMagic = void 0;
			ast.#parts = [str.substring(pos - 1)];
			return i;
		}
		#canAdoptWithSpace(child) {
			return this.#canAdopt(child, adoptionWithSpaceMap);
		}
		#canAdopt(child, map = adoptionMap) {
			if (!child || typeof child !== "object" || child.type !== null || child.#parts.length !== 1 || this.type === null) return false;
			const gc = child.#parts[0];
			if (!gc || typeof gc !== "object" || gc.type === null) return false;
			return this.#canAdoptType(gc.type, map);
		}
		#canAdoptType(c, map = adoptionAnyMap) {
			return !!map.get(this.type)?.includes(c);
		}
		#adoptWithSpace(child, index) {
			const gc = child.#parts[0];
			const blank = new _a(null, gc, this.options);
			blank.#parts.push("");
			gc.push(blank);
			this.#adopt(child, index);
		}
		#adopt(child, index) {
			const gc = child.#parts[0];
			this.#parts.splice(index, 1, ...gc.#parts);
			for (const p of gc.#parts) if (typeof p === "object") p.#parent = this;
			this.#toString = void 0;
		}
		#canUsurpType(c) {
			return !!usurpMap.get(this.type)?.has(c);
		}
		#canUsurp(child) {
			if (!child || typeof child !== "object" || child.type !== null || child.#parts.length !== 1 || this.type === null || this.#parts.length !== 1) return false;
			const gc = child.#parts[0];
			if (!gc || typeof gc !== "object" || gc.type === null) return false;
			return this.#canUsurpType(gc.type);
		}
		#usurp(child) {
			const m = usurpMap.get(this.type);
			const gc = child.#parts[0];
			const nt = m?.get(gc.type);
			/* c8 ignore start - impossible */
			if (!nt) return false;
			/* c8 ignore stop */
			this.#parts = gc.#parts;
			for (const p of this.#parts) if (typeof p === "object") p.#parent = this;
			this.type = nt;
			this.#toString = void 0;
			this.#emptyExt = false;
		}
		static fromGlob(pattern, options = {}) {
			const ast = new _a(null, void 0, options);
			_a.#parseAST(pattern, ast, 0, options, 0);
			return ast;
		}
		toMMPattern() {
			/* c8 ignore start */
			if (this !== this.#root) return this.#root.toMMPattern();
			/* c8 ignore stop */
			const glob = this.toString();
			const [re, body, hasMagic, uflag] = this.toRegExpSource();
			if (!(hasMagic || this.#hasMagic || this.#options.nocase && !this.#options.nocaseMagicOnly && glob.toUpperCase() !== glob.toLowerCase())) return body;
			const flags = (this.#options.nocase ? "i" : "") + (uflag ? "u" : "");
			return Object.assign(new RegExp(`^${re}$`, flags), {
				_src: re,
				_glob: glob
			});
		}
		get options() {
			return this.#options;
		}
		toRegExpSource(allowDot) {
			const dot = allowDot ?? !!this.#options.dot;
			if (this.#root === this) {
				this.#flatten();
				this.#fillNegs();
			}
			if (!isExtglobAST(this)) {
				const noEmpty = this.isStart() && this.isEnd() && !this.#parts.some((s) => typeof s !== "string");
				const src = this.#parts.map((p) => {
					const [re, _, hasMagic, uflag] = typeof p === "string" ? _a.#parseGlob(p, this.#hasMagic, noEmpty) : p.toRegExpSource(allowDot);
					this.#hasMagic = this.#hasMagic || hasMagic;
					this.#uflag = this.#uflag || uflag;
					return re;
				}).join("");
				let start = "";
				if (this.isStart()) {
					if (typeof this.#parts[0] === "string") {
						if (!(this.#parts.length === 1 && justDots.has(this.#parts[0]))) {
							const aps = addPatternStart;
							const needNoTrav = dot && aps.has(src.charAt(0)) || src.startsWith("\\.") && aps.has(src.charAt(2)) || src.startsWith("\\.\\.") && aps.has(src.charAt(4));
							const needNoDot = !dot && !allowDot && aps.has(src.charAt(0));
							start = needNoTrav ? startNoTraversal : needNoDot ? startNoDot : "";
						}
					}
				}
				let end = "";
				if (this.isEnd() && this.#root.#filledNegs && this.#parent?.type === "!") end = "(?:$|\\/)";
				return [
					start + src + end,
					(0, unescape_js_1.unescape)(src),
					this.#hasMagic = !!this.#hasMagic,
					this.#uflag
				];
			}
			const repeated = this.type === "*" || this.type === "+";
			const start = this.type === "!" ? "(?:(?!(?:" : "(?:";
			let body = this.#partsToRegExp(dot);
			if (this.isStart() && this.isEnd() && !body && this.type !== "!") {
				const s = this.toString();
				const me = this;
				me.#parts = [s];
				me.type = null;
				me.#hasMagic = void 0;
				return [
					s,
					(0, unescape_js_1.unescape)(this.toString()),
					false,
					false
				];
			}
			let bodyDotAllowed = !repeated || allowDot || dot || false ? "" : this.#partsToRegExp(true);
			if (bodyDotAllowed === body) bodyDotAllowed = "";
			if (bodyDotAllowed) body = `(?:${body})(?:${bodyDotAllowed})*?`;
			let final = "";
			if (this.type === "!" && this.#emptyExt) final = (this.isStart() && !dot ? startNoDot : "") + starNoEmpty;
			else {
				const close = this.type === "!" ? "))" + (this.isStart() && !dot && !allowDot ? startNoDot : "") + "[^/]*?)" : this.type === "@" ? ")" : this.type === "?" ? ")?" : this.type === "+" && bodyDotAllowed ? ")" : this.type === "*" && bodyDotAllowed ? `)?` : `)${this.type}`;
				final = start + body + close;
			}
			return [
				final,
				(0, unescape_js_1.unescape)(body),
				this.#hasMagic = !!this.#hasMagic,
				this.#uflag
			];
		}
		#flatten() {
			if (!isExtglobAST(this)) {
				for (const p of this.#parts) if (typeof p === "object") p.#flatten();
			} else {
				let iterations = 0;
				let done = false;
				do {
					done = true;
					for (let i = 0; i < this.#parts.length; i++) {
						const c = this.#parts[i];
						if (typeof c === "object") {
							c.#flatten();
							if (this.#canAdopt(c)) {
								done = false;
								this.#adopt(c, i);
							} else if (this.#canAdoptWithSpace(c)) {
								done = false;
								this.#adoptWithSpace(c, i);
							} else if (this.#canUsurp(c)) {
								done = false;
								this.#usurp(c);
							}
						}
					}
				} while (!done && ++iterations < 10);
			}
			this.#toString = void 0;
		}
		#partsToRegExp(dot) {
			return this.#parts.map((p) => {
				/* c8 ignore start */
				if (typeof p === "string") throw new Error("string type in extglob ast??");
				/* c8 ignore stop */
				const [re, _, _hasMagic, uflag] = p.toRegExpSource(dot);
				this.#uflag = this.#uflag || uflag;
				return re;
			}).filter((p) => !(this.isStart() && this.isEnd()) || !!p).join("|");
		}
		static #parseGlob(glob, hasMagic, noEmpty = false) {
			let escaping = false;
			let re = "";
			let uflag = false;
			let inStar = false;
			for (let i = 0; i < glob.length; i++) {
				const c = glob.charAt(i);
				if (escaping) {
					escaping = false;
					re += (reSpecials.has(c) ? "\\" : "") + c;
					continue;
				}
				if (c === "*") {
					if (inStar) continue;
					inStar = true;
					re += noEmpty && /^[*]+$/.test(glob) ? starNoEmpty : star;
					hasMagic = true;
					continue;
				} else inStar = false;
				if (c === "\\") {
					if (i === glob.length - 1) re += "\\\\";
					else escaping = true;
					continue;
				}
				if (c === "[") {
					const [src, needUflag, consumed, magic] = (0, brace_expressions_js_1.parseClass)(glob, i);
					if (consumed) {
						re += src;
						uflag = uflag || needUflag;
						i += consumed - 1;
						hasMagic = hasMagic || magic;
						continue;
					}
				}
				if (c === "?") {
					re += qmark;
					hasMagic = true;
					continue;
				}
				re += regExpEscape(c);
			}
			return [
				re,
				(0, unescape_js_1.unescape)(glob),
				!!hasMagic,
				uflag
			];
		}
	};
	exports.AST = AST;
	_a = AST;
}));
// node_modules/minimatch/dist/commonjs/escape.js
var require_escape = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.escape = void 0;
	/**
	* Escape all magic characters in a glob pattern.
	*
	* If the {@link MinimatchOptions.windowsPathsNoEscape}
	* option is used, then characters are escaped by wrapping in `[]`, because
	* a magic character wrapped in a character class can only be satisfied by
	* that exact character.  In this mode, `\` is _not_ escaped, because it is
	* not interpreted as a magic character, but instead as a path separator.
	*
	* If the {@link MinimatchOptions.magicalBraces} option is used,
	* then braces (`{` and `}`) will be escaped.
	*/
	var escape = (s, { windowsPathsNoEscape = false, magicalBraces = false } = {}) => {
		if (magicalBraces) return windowsPathsNoEscape ? s.replace(/[?*()[\]{}]/g, "[$&]") : s.replace(/[?*()[\]\\{}]/g, "\\$&");
		return windowsPathsNoEscape ? s.replace(/[?*()[\]]/g, "[$&]") : s.replace(/[?*()[\]\\]/g, "\\$&");
	};
	exports.escape = escape;
}));
// node_modules/minimatch/dist/commonjs/index.js
var require_commonjs = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.unescape = exports.escape = exports.AST = exports.Minimatch = exports.match = exports.makeRe = exports.braceExpand = exports.defaults = exports.filter = exports.GLOBSTAR = exports.sep = exports.minimatch = void 0;
	var brace_expansion_1 = require_commonjs$1();
	var assert_valid_pattern_js_1 = require_assert_valid_pattern();
	var ast_js_1 = require_ast();
	var escape_js_1 = require_escape();
	var unescape_js_1 = require_unescape();
	var minimatch = (p, pattern, options = {}) => {
		(0, assert_valid_pattern_js_1.assertValidPattern)(pattern);
		if (!options.nocomment && pattern.charAt(0) === "#") return false;
		return new Minimatch(pattern, options).match(p);
	};
	exports.minimatch = minimatch;
	var starDotExtRE = /^\*+([^+@!?*[(]*)$/;
	var starDotExtTest = (ext) => (f) => !f.startsWith(".") && f.endsWith(ext);
	var starDotExtTestDot = (ext) => (f) => f.endsWith(ext);
	var starDotExtTestNocase = (ext) => {
		ext = ext.toLowerCase();
		return (f) => !f.startsWith(".") && f.toLowerCase().endsWith(ext);
	};
	var starDotExtTestNocaseDot = (ext) => {
		ext = ext.toLowerCase();
		return (f) => f.toLowerCase().endsWith(ext);
	};
	var starDotStarRE = /^\*+\.\*+$/;
	var starDotStarTest = (f) => !f.startsWith(".") && f.includes(".");
	var starDotStarTestDot = (f) => f !== "." && f !== ".." && f.includes(".");
	var dotStarRE = /^\.\*+$/;
	var dotStarTest = (f) => f !== "." && f !== ".." && f.startsWith(".");
	var starRE = /^\*+$/;
	var starTest = (f) => f.length !== 0 && !f.startsWith(".");
	var starTestDot = (f) => f.length !== 0 && f !== "." && f !== "..";
	var qmarksRE = /^\?+([^+@!?*[(]*)?$/;
	var qmarksTestNocase = ([$0, ext = ""]) => {
		const noext = qmarksTestNoExt([$0]);
		if (!ext) return noext;
		ext = ext.toLowerCase();
		return (f) => noext(f) && f.toLowerCase().endsWith(ext);
	};
	var qmarksTestNocaseDot = ([$0, ext = ""]) => {
		const noext = qmarksTestNoExtDot([$0]);
		if (!ext) return noext;
		ext = ext.toLowerCase();
		return (f) => noext(f) && f.toLowerCase().endsWith(ext);
	};
	var qmarksTestDot = ([$0, ext = ""]) => {
		const noext = qmarksTestNoExtDot([$0]);
		return !ext ? noext : (f) => noext(f) && f.endsWith(ext);
	};
	var qmarksTest = ([$0, ext = ""]) => {
		const noext = qmarksTestNoExt([$0]);
		return !ext ? noext : (f) => noext(f) && f.endsWith(ext);
	};
	var qmarksTestNoExt = ([$0]) => {
		const len = $0.length;
		return (f) => f.length === len && !f.startsWith(".");
	};
	var qmarksTestNoExtDot = ([$0]) => {
		const len = $0.length;
		return (f) => f.length === len && f !== "." && f !== "..";
	};
	/* c8 ignore start */
	var defaultPlatform = typeof process === "object" && process ? typeof process.env === "object" && process.env && process.env.__MINIMATCH_TESTING_PLATFORM__ || process.platform : "posix";
	var path = {
		win32: { sep: "\\" },
		posix: { sep: "/" }
	};
	/* c8 ignore stop */
	exports.sep = defaultPlatform === "win32" ? path.win32.sep : path.posix.sep;
	exports.minimatch.sep = exports.sep;
	exports.GLOBSTAR = Symbol("globstar **");
	exports.minimatch.GLOBSTAR = exports.GLOBSTAR;
	var star = "[^/]*?";
	var twoStarDot = "(?:(?!(?:\\/|^)(?:\\.{1,2})($|\\/)).)*?";
	var twoStarNoDot = "(?:(?!(?:\\/|^)\\.).)*?";
	var filter = (pattern, options = {}) => (p) => (0, exports.minimatch)(p, pattern, options);
	exports.filter = filter;
	exports.minimatch.filter = exports.filter;
	var ext = (a, b = {}) => Object.assign({}, a, b);
	var defaults = (def) => {
		if (!def || typeof def !== "object" || !Object.keys(def).length) return exports.minimatch;
		const orig = exports.minimatch;
		const m = (p, pattern, options = {}) => orig(p, pattern, ext(def, options));
		return Object.assign(m, {
			Minimatch: class Minimatch extends orig.Minimatch {
				constructor(pattern, options = {}) {
					super(pattern, ext(def, options));
				}
				static defaults(options) {
					return orig.defaults(ext(def, options)).Minimatch;
				}
			},
			AST: class AST extends orig.AST {
				/* c8 ignore start */
				constructor(type, parent, options = {}) {
					super(type, parent, ext(def, options));
				}
				/* c8 ignore stop */
				static fromGlob(pattern, options = {}) {
					return orig.AST.fromGlob(pattern, ext(def, options));
				}
			},
			unescape: (s, options = {}) => orig.unescape(s, ext(def, options)),
			escape: (s, options = {}) => orig.escape(s, ext(def, options)),
			filter: (pattern, options = {}) => orig.filter(pattern, ext(def, options)),
			defaults: (options) => orig.defaults(ext(def, options)),
			makeRe: (pattern, options = {}) => orig.makeRe(pattern, ext(def, options)),
			braceExpand: (pattern, options = {}) => orig.braceExpand(pattern, ext(def, options)),
			match: (list, pattern, options = {}) => orig.match(list, pattern, ext(def, options)),
			sep: orig.sep,
			GLOBSTAR: exports.GLOBSTAR
		});
	};
	exports.defaults = defaults;
	exports.minimatch.defaults = exports.defaults;
	var braceExpand = (pattern, options = {}) => {
		(0, assert_valid_pattern_js_1.assertValidPattern)(pattern);
		if (options.nobrace || !/\{(?:(?!\{).)*\}/.test(pattern)) return [pattern];
		return (0, brace_expansion_1.expand)(pattern, { max: options.braceExpandMax });
	};
	exports.braceExpand = braceExpand;
	exports.minimatch.braceExpand = exports.braceExpand;
	var makeRe = (pattern, options = {}) => new Minimatch(pattern, options).makeRe();
	exports.makeRe = makeRe;
	exports.minimatch.makeRe = exports.makeRe;
	var match = (list, pattern, options = {}) => {
		const mm = new Minimatch(pattern, options);
		list = list.filter((f) => mm.match(f));
		if (mm.options.nonull && !list.length) list.push(pattern);
		return list;
	};
	exports.match = match;
	exports.minimatch.match = exports.match;
	var globMagic = /[?*]|[+@!]\(.*?\)|\[|\]/;
	var regExpEscape = (s) => s.replace(/[-[\]{}()*+?.,\\^$|#\s]/g, "\\$&");
	var Minimatch = class {
		options;
		set;
		pattern;
		windowsPathsNoEscape;
		nonegate;
		negate;
		comment;
		empty;
		preserveMultipleSlashes;
		partial;
		globSet;
		globParts;
		nocase;
		isWindows;
		platform;
		windowsNoMagicRoot;
		maxGlobstarRecursion;
		regexp;
		constructor(pattern, options = {}) {
			(0, assert_valid_pattern_js_1.assertValidPattern)(pattern);
			options = options || {};
			this.options = options;
			this.maxGlobstarRecursion = options.maxGlobstarRecursion ?? 200;
			this.pattern = pattern;
			this.platform = options.platform || defaultPlatform;
			this.isWindows = this.platform === "win32";
			const awe = "allowWindowsEscape";
			this.windowsPathsNoEscape = !!options.windowsPathsNoEscape || options[awe] === false;
			if (this.windowsPathsNoEscape) this.pattern = this.pattern.replace(/\\/g, "/");
			this.preserveMultipleSlashes = !!options.preserveMultipleSlashes;
			this.regexp = null;
			this.negate = false;
			this.nonegate = !!options.nonegate;
			this.comment = false;
			this.empty = false;
			this.partial = !!options.partial;
			this.nocase = !!this.options.nocase;
			this.windowsNoMagicRoot = options.windowsNoMagicRoot !== void 0 ? options.windowsNoMagicRoot : !!(this.isWindows && this.nocase);
			this.globSet = [];
			this.globParts = [];
			this.set = [];
			this.make();
		}
		hasMagic() {
			if (this.options.magicalBraces && this.set.length > 1) return true;
			for (const pattern of this.set) for (const part of pattern) if (typeof part !== "string") return true;
			return false;
		}
		debug(..._) {}
		make() {
			const pattern = this.pattern;
			const options = this.options;
			if (!options.nocomment && pattern.charAt(0) === "#") {
				this.comment = true;
				return;
			}
			if (!pattern) {
				this.empty = true;
				return;
			}
			this.parseNegate();
			this.globSet = [...new Set(this.braceExpand())];
			if (options.debug) this.debug = (...args) => console.error(...args);
			this.debug(this.pattern, this.globSet);
			const rawGlobParts = this.globSet.map((s) => this.slashSplit(s));
			this.globParts = this.preprocess(rawGlobParts);
			this.debug(this.pattern, this.globParts);
			let set = this.globParts.map((s, _, __) => {
				if (this.isWindows && this.windowsNoMagicRoot) {
					const isUNC = s[0] === "" && s[1] === "" && (s[2] === "?" || !globMagic.test(s[2])) && !globMagic.test(s[3]);
					const isDrive = /^[a-z]:/i.test(s[0]);
					if (isUNC) return [...s.slice(0, 4), ...s.slice(4).map((ss) => this.parse(ss))];
					else if (isDrive) return [s[0], ...s.slice(1).map((ss) => this.parse(ss))];
				}
				return s.map((ss) => this.parse(ss));
			});
			this.debug(this.pattern, set);
			this.set = set.filter((s) => s.indexOf(false) === -1);
			if (this.isWindows) for (let i = 0; i < this.set.length; i++) {
				const p = this.set[i];
				if (p[0] === "" && p[1] === "" && this.globParts[i][2] === "?" && typeof p[3] === "string" && /^[a-z]:$/i.test(p[3])) p[2] = "?";
			}
			this.debug(this.pattern, this.set);
		}
		preprocess(globParts) {
			if (this.options.noglobstar) {
				for (const partset of globParts) for (let j = 0; j < partset.length; j++) if (partset[j] === "**") partset[j] = "*";
			}
			const { optimizationLevel = 1 } = this.options;
			if (optimizationLevel >= 2) {
				globParts = this.firstPhasePreProcess(globParts);
				globParts = this.secondPhasePreProcess(globParts);
			} else if (optimizationLevel >= 1) globParts = this.levelOneOptimize(globParts);
			else globParts = this.adjascentGlobstarOptimize(globParts);
			return globParts;
		}
		adjascentGlobstarOptimize(globParts) {
			return globParts.map((parts) => {
				let gs = -1;
				while (-1 !== (gs = parts.indexOf("**", gs + 1))) {
					let i = gs;
					while (parts[i + 1] === "**") i++;
					if (i !== gs) parts.splice(gs, i - gs);
				}
				return parts;
			});
		}
		levelOneOptimize(globParts) {
			return globParts.map((parts) => {
				parts = parts.reduce((set, part) => {
					const prev = set[set.length - 1];
					if (part === "**" && prev === "**") return set;
					if (part === "..") {
						if (prev && prev !== ".." && prev !== "." && prev !== "**") {
							set.pop();
							return set;
						}
					}
					set.push(part);
					return set;
				}, []);
				return parts.length === 0 ? [""] : parts;
			});
		}
		levelTwoFileOptimize(parts) {
			if (!Array.isArray(parts)) parts = this.slashSplit(parts);
			let didSomething = false;
			do {
				didSomething = false;
				if (!this.preserveMultipleSlashes) {
					for (let i = 1; i < parts.length - 1; i++) {
						const p = parts[i];
						if (i === 1 && p === "" && parts[0] === "") continue;
						if (p === "." || p === "") {
							didSomething = true;
							parts.splice(i, 1);
							i--;
						}
					}
					if (parts[0] === "." && parts.length === 2 && (parts[1] === "." || parts[1] === "")) {
						didSomething = true;
						parts.pop();
					}
				}
				let dd = 0;
				while (-1 !== (dd = parts.indexOf("..", dd + 1))) {
					const p = parts[dd - 1];
					if (p && p !== "." && p !== ".." && p !== "**" && !(this.isWindows && /^[a-z]:$/i.test(p))) {
						didSomething = true;
						parts.splice(dd - 1, 2);
						dd -= 2;
					}
				}
			} while (didSomething);
			return parts.length === 0 ? [""] : parts;
		}
		firstPhasePreProcess(globParts) {
			let didSomething = false;
			do {
				didSomething = false;
				for (let parts of globParts) {
					let gs = -1;
					while (-1 !== (gs = parts.indexOf("**", gs + 1))) {
						let gss = gs;
						while (parts[gss + 1] === "**") gss++;
						if (gss > gs) parts.splice(gs + 1, gss - gs);
						let next = parts[gs + 1];
						const p = parts[gs + 2];
						const p2 = parts[gs + 3];
						if (next !== "..") continue;
						if (!p || p === "." || p === ".." || !p2 || p2 === "." || p2 === "..") continue;
						didSomething = true;
						parts.splice(gs, 1);
						const other = parts.slice(0);
						other[gs] = "**";
						globParts.push(other);
						gs--;
					}
					if (!this.preserveMultipleSlashes) {
						for (let i = 1; i < parts.length - 1; i++) {
							const p = parts[i];
							if (i === 1 && p === "" && parts[0] === "") continue;
							if (p === "." || p === "") {
								didSomething = true;
								parts.splice(i, 1);
								i--;
							}
						}
						if (parts[0] === "." && parts.length === 2 && (parts[1] === "." || parts[1] === "")) {
							didSomething = true;
							parts.pop();
						}
					}
					let dd = 0;
					while (-1 !== (dd = parts.indexOf("..", dd + 1))) {
						const p = parts[dd - 1];
						if (p && p !== "." && p !== ".." && p !== "**") {
							didSomething = true;
							const splin = dd === 1 && parts[dd + 1] === "**" ? ["."] : [];
							parts.splice(dd - 1, 2, ...splin);
							if (parts.length === 0) parts.push("");
							dd -= 2;
						}
					}
				}
			} while (didSomething);
			return globParts;
		}
		secondPhasePreProcess(globParts) {
			for (let i = 0; i < globParts.length - 1; i++) for (let j = i + 1; j < globParts.length; j++) {
				const matched = this.partsMatch(globParts[i], globParts[j], !this.preserveMultipleSlashes);
				if (matched) {
					globParts[i] = [];
					globParts[j] = matched;
					break;
				}
			}
			return globParts.filter((gs) => gs.length);
		}
		partsMatch(a, b, emptyGSMatch = false) {
			let ai = 0;
			let bi = 0;
			let result = [];
			let which = "";
			while (ai < a.length && bi < b.length) if (a[ai] === b[bi]) {
				result.push(which === "b" ? b[bi] : a[ai]);
				ai++;
				bi++;
			} else if (emptyGSMatch && a[ai] === "**" && b[bi] === a[ai + 1]) {
				result.push(a[ai]);
				ai++;
			} else if (emptyGSMatch && b[bi] === "**" && a[ai] === b[bi + 1]) {
				result.push(b[bi]);
				bi++;
			} else if (a[ai] === "*" && b[bi] && (this.options.dot || !b[bi].startsWith(".")) && b[bi] !== "**") {
				if (which === "b") return false;
				which = "a";
				result.push(a[ai]);
				ai++;
				bi++;
			} else if (b[bi] === "*" && a[ai] && (this.options.dot || !a[ai].startsWith(".")) && a[ai] !== "**") {
				if (which === "a") return false;
				which = "b";
				result.push(b[bi]);
				ai++;
				bi++;
			} else return false;
			return a.length === b.length && result;
		}
		parseNegate() {
			if (this.nonegate) return;
			const pattern = this.pattern;
			let negate = false;
			let negateOffset = 0;
			for (let i = 0; i < pattern.length && pattern.charAt(i) === "!"; i++) {
				negate = !negate;
				negateOffset++;
			}
			if (negateOffset) this.pattern = pattern.slice(negateOffset);
			this.negate = negate;
		}
		matchOne(file, pattern, partial = false) {
			let fileStartIndex = 0;
			let patternStartIndex = 0;
			if (this.isWindows) {
				const fileDrive = typeof file[0] === "string" && /^[a-z]:$/i.test(file[0]);
				const fileUNC = !fileDrive && file[0] === "" && file[1] === "" && file[2] === "?" && /^[a-z]:$/i.test(file[3]);
				const patternDrive = typeof pattern[0] === "string" && /^[a-z]:$/i.test(pattern[0]);
				const patternUNC = !patternDrive && pattern[0] === "" && pattern[1] === "" && pattern[2] === "?" && typeof pattern[3] === "string" && /^[a-z]:$/i.test(pattern[3]);
				const fdi = fileUNC ? 3 : fileDrive ? 0 : void 0;
				const pdi = patternUNC ? 3 : patternDrive ? 0 : void 0;
				if (typeof fdi === "number" && typeof pdi === "number") {
					const [fd, pd] = [file[fdi], pattern[pdi]];
					if (fd.toLowerCase() === pd.toLowerCase()) {
						pattern[pdi] = fd;
						patternStartIndex = pdi;
						fileStartIndex = fdi;
					}
				}
			}
			const { optimizationLevel = 1 } = this.options;
			if (optimizationLevel >= 2) file = this.levelTwoFileOptimize(file);
			if (pattern.includes(exports.GLOBSTAR)) return this.#matchGlobstar(file, pattern, partial, fileStartIndex, patternStartIndex);
			return this.#matchOne(file, pattern, partial, fileStartIndex, patternStartIndex);
		}
		#matchGlobstar(file, pattern, partial, fileIndex, patternIndex) {
			const firstgs = pattern.indexOf(exports.GLOBSTAR, patternIndex);
			const lastgs = pattern.lastIndexOf(exports.GLOBSTAR);
			const [head, body, tail] = partial ? [
				pattern.slice(patternIndex, firstgs),
				pattern.slice(firstgs + 1),
				[]
			] : [
				pattern.slice(patternIndex, firstgs),
				pattern.slice(firstgs + 1, lastgs),
				pattern.slice(lastgs + 1)
			];
			if (head.length) {
				const fileHead = file.slice(fileIndex, fileIndex + head.length);
				if (!this.#matchOne(fileHead, head, partial, 0, 0)) return false;
				fileIndex += head.length;
				patternIndex += head.length;
			}
			let fileTailMatch = 0;
			if (tail.length) {
				if (tail.length + fileIndex > file.length) return false;
				let tailStart = file.length - tail.length;
				if (this.#matchOne(file, tail, partial, tailStart, 0)) fileTailMatch = tail.length;
				else {
					if (file[file.length - 1] !== "" || fileIndex + tail.length === file.length) return false;
					tailStart--;
					if (!this.#matchOne(file, tail, partial, tailStart, 0)) return false;
					fileTailMatch = tail.length + 1;
				}
			}
			if (!body.length) {
				let sawSome = !!fileTailMatch;
				for (let i = fileIndex; i < file.length - fileTailMatch; i++) {
					const f = String(file[i]);
					sawSome = true;
					if (f === "." || f === ".." || !this.options.dot && f.startsWith(".")) return false;
				}
				return partial || sawSome;
			}
			const bodySegments = [[[], 0]];
			let currentBody = bodySegments[0];
			let nonGsParts = 0;
			const nonGsPartsSums = [0];
			for (const b of body) if (b === exports.GLOBSTAR) {
				nonGsPartsSums.push(nonGsParts);
				currentBody = [[], 0];
				bodySegments.push(currentBody);
			} else {
				currentBody[0].push(b);
				nonGsParts++;
			}
			let i = bodySegments.length - 1;
			const fileLength = file.length - fileTailMatch;
			for (const b of bodySegments) b[1] = fileLength - (nonGsPartsSums[i--] + b[0].length);
			return !!this.#matchGlobStarBodySections(file, bodySegments, fileIndex, 0, partial, 0, !!fileTailMatch);
		}
		#matchGlobStarBodySections(file, bodySegments, fileIndex, bodyIndex, partial, globStarDepth, sawTail) {
			const bs = bodySegments[bodyIndex];
			if (!bs) {
				for (let i = fileIndex; i < file.length; i++) {
					sawTail = true;
					const f = file[i];
					if (f === "." || f === ".." || !this.options.dot && f.startsWith(".")) return false;
				}
				return sawTail;
			}
			const [body, after] = bs;
			while (fileIndex <= after) {
				if (this.#matchOne(file.slice(0, fileIndex + body.length), body, partial, fileIndex, 0) && globStarDepth < this.maxGlobstarRecursion) {
					const sub = this.#matchGlobStarBodySections(file, bodySegments, fileIndex + body.length, bodyIndex + 1, partial, globStarDepth + 1, sawTail);
					if (sub !== false) return sub;
				}
				const f = file[fileIndex];
				if (f === "." || f === ".." || !this.options.dot && f.startsWith(".")) return false;
				fileIndex++;
			}
			return partial || null;
		}
		#matchOne(file, pattern, partial, fileIndex, patternIndex) {
			let fi;
			let pi;
			let pl;
			let fl;
			for (fi = fileIndex, pi = patternIndex, fl = file.length, pl = pattern.length; fi < fl && pi < pl; fi++, pi++) {
				this.debug("matchOne loop");
				let p = pattern[pi];
				let f = file[fi];
				this.debug(pattern, p, f);
				/* c8 ignore start */
				if (p === false || p === exports.GLOBSTAR) return false;
				/* c8 ignore stop */
				let hit;
				if (typeof p === "string") {
					hit = f === p;
					this.debug("string match", p, f, hit);
				} else {
					hit = p.test(f);
					this.debug("pattern match", p, f, hit);
				}
				if (!hit) return false;
			}
			if (fi === fl && pi === pl) return true;
			else if (fi === fl) return partial;
			else if (pi === pl) return fi === fl - 1 && file[fi] === "";
			else throw new Error("wtf?");
			/* c8 ignore stop */
		}
		braceExpand() {
			return (0, exports.braceExpand)(this.pattern, this.options);
		}
		parse(pattern) {
			(0, assert_valid_pattern_js_1.assertValidPattern)(pattern);
			const options = this.options;
			if (pattern === "**") return exports.GLOBSTAR;
			if (pattern === "") return "";
			let m;
			let fastTest = null;
			if (m = pattern.match(starRE)) fastTest = options.dot ? starTestDot : starTest;
			else if (m = pattern.match(starDotExtRE)) fastTest = (options.nocase ? options.dot ? starDotExtTestNocaseDot : starDotExtTestNocase : options.dot ? starDotExtTestDot : starDotExtTest)(m[1]);
			else if (m = pattern.match(qmarksRE)) fastTest = (options.nocase ? options.dot ? qmarksTestNocaseDot : qmarksTestNocase : options.dot ? qmarksTestDot : qmarksTest)(m);
			else if (m = pattern.match(starDotStarRE)) fastTest = options.dot ? starDotStarTestDot : starDotStarTest;
			else if (m = pattern.match(dotStarRE)) fastTest = dotStarTest;
			const re = ast_js_1.AST.fromGlob(pattern, this.options).toMMPattern();
			if (fastTest && typeof re === "object") Reflect.defineProperty(re, "test", { value: fastTest });
			return re;
		}
		makeRe() {
			if (this.regexp || this.regexp === false) return this.regexp;
			const set = this.set;
			if (!set.length) {
				this.regexp = false;
				return this.regexp;
			}
			const options = this.options;
			const twoStar = options.noglobstar ? star : options.dot ? twoStarDot : twoStarNoDot;
			const flags = new Set(options.nocase ? ["i"] : []);
			let re = set.map((pattern) => {
				const pp = pattern.map((p) => {
					if (p instanceof RegExp) for (const f of p.flags.split("")) flags.add(f);
					return typeof p === "string" ? regExpEscape(p) : p === exports.GLOBSTAR ? exports.GLOBSTAR : p._src;
				});
				pp.forEach((p, i) => {
					const next = pp[i + 1];
					const prev = pp[i - 1];
					if (p !== exports.GLOBSTAR || prev === exports.GLOBSTAR) return;
					if (prev === void 0) {
						if (next !== void 0 && next !== exports.GLOBSTAR) pp[i + 1] = "(?:\\/|" + twoStar + "\\/)?" + next;
						else pp[i] = twoStar;
					} else if (next === void 0) pp[i - 1] = prev + "(?:\\/|\\/" + twoStar + ")?";
					else if (next !== exports.GLOBSTAR) {
						pp[i - 1] = prev + "(?:\\/|\\/" + twoStar + "\\/)" + next;
						pp[i + 1] = exports.GLOBSTAR;
					}
				});
				const filtered = pp.filter((p) => p !== exports.GLOBSTAR);
				if (this.partial && filtered.length >= 1) {
					const prefixes = [];
					for (let i = 1; i <= filtered.length; i++) prefixes.push(filtered.slice(0, i).join("/"));
					return "(?:" + prefixes.join("|") + ")";
				}
				return filtered.join("/");
			}).join("|");
			const [open, close] = set.length > 1 ? ["(?:", ")"] : ["", ""];
			re = "^" + open + re + close + "$";
			if (this.partial) re = "^(?:\\/|" + open + re.slice(1, -1) + close + ")$";
			if (this.negate) re = "^(?!" + re + ").+$";
			try {
				this.regexp = new RegExp(re, [...flags].join(""));
			} catch {
				this.regexp = false;
			}
			/* c8 ignore stop */
			return this.regexp;
		}
		slashSplit(p) {
			if (this.preserveMultipleSlashes) return p.split("/");
			else if (this.isWindows && /^\/\/[^/]+/.test(p)) return ["", ...p.split(/\/+/)];
			else return p.split(/\/+/);
		}
		match(f, partial = this.partial) {
			this.debug("match", f, this.pattern);
			if (this.comment) return false;
			if (this.empty) return f === "";
			if (f === "/" && partial) return true;
			const options = this.options;
			if (this.isWindows) f = f.split("\\").join("/");
			const ff = this.slashSplit(f);
			this.debug(this.pattern, "split", ff);
			const set = this.set;
			this.debug(this.pattern, "set", set);
			let filename = ff[ff.length - 1];
			if (!filename) for (let i = ff.length - 2; !filename && i >= 0; i--) filename = ff[i];
			for (const pattern of set) {
				let file = ff;
				if (options.matchBase && pattern.length === 1) file = [filename];
				if (this.matchOne(file, pattern, partial)) {
					if (options.flipNegate) return true;
					return !this.negate;
				}
			}
			if (options.flipNegate) return false;
			return this.negate;
		}
		static defaults(def) {
			return exports.minimatch.defaults(def).Minimatch;
		}
	};
	exports.Minimatch = Minimatch;
	/* c8 ignore start */
	var ast_js_2 = require_ast();
	Object.defineProperty(exports, "AST", {
		enumerable: true,
		get: function() {
			return ast_js_2.AST;
		}
	});
	var escape_js_2 = require_escape();
	Object.defineProperty(exports, "escape", {
		enumerable: true,
		get: function() {
			return escape_js_2.escape;
		}
	});
	var unescape_js_2 = require_unescape();
	Object.defineProperty(exports, "unescape", {
		enumerable: true,
		get: function() {
			return unescape_js_2.unescape;
		}
	});
	/* c8 ignore stop */
	exports.minimatch.AST = ast_js_1.AST;
	exports.minimatch.Minimatch = Minimatch;
	exports.minimatch.escape = escape_js_1.escape;
	exports.minimatch.unescape = unescape_js_1.unescape;
}));
// node_modules/vscode-languageclient/lib/common/utils/globPattern.js
var require_globPattern = /* @__PURE__ */ __commonJSMin(((exports, module, this$14) => {
	var __createBinding = this$14 && this$14.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$14 && this$14.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$14 && this$14.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.matchGlobPattern = matchGlobPattern;
	var minimatch = __importStar(require_commonjs());
	var vscode_1 = require("vscode");
	function matchGlobPattern(pattern, resource) {
		let miniMatchPattern;
		if (typeof pattern === "string") miniMatchPattern = pattern.replace(/\\/g, "/");
		else try {
			const baseUri = vscode_1.Uri.parse(typeof pattern.baseUri === "string" ? pattern.baseUri : pattern.baseUri.uri);
			miniMatchPattern = baseUri.with({ path: baseUri.path + "/" + pattern.pattern }).fsPath.replace(/\\/g, "/");
		} catch (error) {
			return false;
		}
		const matcher = new minimatch.Minimatch(miniMatchPattern, { noext: true });
		if (!matcher.makeRe()) return false;
		return matcher.match(resource.fsPath);
	}
}));
// node_modules/vscode-languageclient/lib/common/diagnostic.js
var require_diagnostic = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.DiagnosticFeature = exports.DiagnosticPullMode = exports.vsdiag = void 0;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var globPattern_1 = require_globPattern();
	var features_1 = require_features();
	function ensure(target, key) {
		if (target[key] === void 0) target[key] = {};
		return target[key];
	}
	var vsdiag;
	(function(vsdiag) {
		(function(DocumentDiagnosticReportKind) {
			DocumentDiagnosticReportKind["full"] = "full";
			DocumentDiagnosticReportKind["unChanged"] = "unChanged";
		})(vsdiag.DocumentDiagnosticReportKind || (vsdiag.DocumentDiagnosticReportKind = {}));
	})(vsdiag || (exports.vsdiag = vsdiag = {}));
	var DiagnosticPullMode;
	(function(DiagnosticPullMode) {
		DiagnosticPullMode["onType"] = "onType";
		DiagnosticPullMode["onSave"] = "onSave";
		DiagnosticPullMode["onFocus"] = "onFocus";
	})(DiagnosticPullMode || (exports.DiagnosticPullMode = DiagnosticPullMode = {}));
	var RequestStateKind;
	(function(RequestStateKind) {
		RequestStateKind["active"] = "open";
		RequestStateKind["reschedule"] = "reschedule";
		RequestStateKind["outDated"] = "drop";
	})(RequestStateKind || (RequestStateKind = {}));
	var PullState;
	(function(PullState) {
		PullState[PullState["document"] = 1] = "document";
		PullState[PullState["workspace"] = 2] = "workspace";
	})(PullState || (PullState = {}));
	var DocumentOrUri;
	(function(DocumentOrUri) {
		function asKey(document) {
			return document instanceof vscode_1.Uri ? document.toString() : document.uri.toString();
		}
		DocumentOrUri.asKey = asKey;
	})(DocumentOrUri || (DocumentOrUri = {}));
	var DocumentPullStateTracker = class {
		documentPullStates;
		workspacePullStates;
		constructor() {
			this.documentPullStates = /* @__PURE__ */ new Map();
			this.workspacePullStates = /* @__PURE__ */ new Map();
		}
		track(kind, document, arg1) {
			const states = kind === PullState.document ? this.documentPullStates : this.workspacePullStates;
			const [key, uri, version] = document instanceof vscode_1.Uri ? [
				document.toString(),
				document,
				arg1
			] : [
				document.uri.toString(),
				document.uri,
				document.version
			];
			let state = states.get(key);
			if (state === void 0) {
				state = {
					document: uri,
					pulledVersion: version,
					resultId: void 0
				};
				states.set(key, state);
			}
			return state;
		}
		update(kind, document, arg1, arg2) {
			const states = kind === PullState.document ? this.documentPullStates : this.workspacePullStates;
			const [key, uri, version, resultId] = document instanceof vscode_1.Uri ? [
				document.toString(),
				document,
				arg1,
				arg2
			] : [
				document.uri.toString(),
				document.uri,
				document.version,
				arg1
			];
			let state = states.get(key);
			if (state === void 0) {
				state = {
					document: uri,
					pulledVersion: version,
					resultId
				};
				states.set(key, state);
			} else {
				state.pulledVersion = version;
				state.resultId = resultId;
			}
		}
		unTrack(kind, document) {
			const key = DocumentOrUri.asKey(document);
			(kind === PullState.document ? this.documentPullStates : this.workspacePullStates).delete(key);
		}
		tracks(kind, document) {
			const key = DocumentOrUri.asKey(document);
			return (kind === PullState.document ? this.documentPullStates : this.workspacePullStates).has(key);
		}
		tracksSameVersion(kind, document) {
			const key = document.uri.toString();
			const state = (kind === PullState.document ? this.documentPullStates : this.workspacePullStates).get(key);
			return state !== void 0 && state.pulledVersion === document.version;
		}
		getResultId(kind, document) {
			const key = DocumentOrUri.asKey(document);
			return (kind === PullState.document ? this.documentPullStates : this.workspacePullStates).get(key)?.resultId;
		}
		getAllResultIds() {
			const result = [];
			for (let [uri, value] of this.workspacePullStates) {
				if (this.documentPullStates.has(uri)) value = this.documentPullStates.get(uri);
				if (value.resultId !== void 0) result.push({
					uri,
					value: value.resultId
				});
			}
			return result;
		}
	};
	var DiagnosticRequestor = class {
		isDisposed;
		client;
		visibleDocuments;
		options;
		onDidChangeDiagnosticsEmitter;
		provider;
		diagnostics;
		openRequests;
		pendingDocumentForgets;
		documentStates;
		workspaceErrorCounter;
		workspaceCancellation;
		workspaceTimeout;
		constructor(client, visibleDocuments, options) {
			this.client = client;
			this.visibleDocuments = visibleDocuments;
			this.options = options;
			this.isDisposed = false;
			this.onDidChangeDiagnosticsEmitter = new vscode_1.EventEmitter();
			this.provider = this.createProvider();
			this.diagnostics = this.createDiagnosticCollection();
			this.openRequests = /* @__PURE__ */ new Map();
			this.pendingDocumentForgets = /* @__PURE__ */ new Map();
			this.documentStates = new DocumentPullStateTracker();
			this.workspaceErrorCounter = 0;
		}
		createDiagnosticCollection() {
			if (this.client.clientOptions.diagnosticCollectionProvider === void 0) return vscode_1.languages.createDiagnosticCollection(this.options.identifier);
			else return this.client.clientOptions.diagnosticCollectionProvider.create(this.options.identifier, features_1.DiagnosticCollectionSource.pull);
		}
		knows(kind, document) {
			const uri = document instanceof vscode_1.Uri ? document : document.uri;
			return this.documentStates.tracks(kind, document) || this.openRequests.has(uri.toString());
		}
		knowsSameVersion(kind, document) {
			const requestState = this.openRequests.get(document.uri.toString());
			if (requestState === void 0) return this.documentStates.tracksSameVersion(kind, document);
			if (requestState.state === RequestStateKind.reschedule) return true;
			if (requestState.state === RequestStateKind.outDated) return false;
			return requestState.version === document.version;
		}
		forget(kind, document) {
			this.documentStates.unTrack(kind, document);
		}
		cancelPendingForget(document) {
			this.pendingDocumentForgets.delete(DocumentOrUri.asKey(document));
		}
		pull(document, cb) {
			if (this.isDisposed) return;
			const uri = document instanceof vscode_1.Uri ? document : document.uri;
			this.pullAsync(document).then(() => {
				if (cb) cb();
			}, (error) => {
				this.client.error(`Document pull failed for text document ${uri.toString()}`, error, false);
			});
		}
		async pullAsync(document, version) {
			if (this.isDisposed) return;
			const isUri = document instanceof vscode_1.Uri;
			const uri = isUri ? document : document.uri;
			const key = uri.toString();
			version = isUri ? version : document.version;
			const currentRequestState = this.openRequests.get(key);
			const documentState = isUri ? this.documentStates.track(PullState.document, document, version) : this.documentStates.track(PullState.document, document);
			if (currentRequestState === void 0) {
				const tokenSource = new vscode_1.CancellationTokenSource();
				this.openRequests.set(key, {
					state: RequestStateKind.active,
					document,
					version,
					tokenSource
				});
				let report;
				let afterState;
				try {
					report = await this.provider.provideDiagnostics(document, documentState.resultId, tokenSource.token) ?? {
						kind: vsdiag.DocumentDiagnosticReportKind.full,
						items: []
					};
				} catch (error) {
					if (error instanceof features_1.LSPCancellationError && vscode_languageserver_protocol_1.DiagnosticServerCancellationData.is(error.data) && error.data.retriggerRequest === false) afterState = {
						state: RequestStateKind.outDated,
						document
					};
					else if (error instanceof vscode_1.CancellationError) afterState = {
						state: RequestStateKind.reschedule,
						document
					};
					else {
						this.openRequests.delete(key);
						throw error;
					}
				}
				afterState = afterState ?? this.openRequests.get(key);
				if (afterState === void 0) {
					this.client.error(`Lost request state in diagnostic pull model. Clearing diagnostics for ${key}`);
					this.diagnostics.delete(uri);
					return;
				}
				this.openRequests.delete(key);
				if (!this.visibleDocuments.isVisible(document)) {
					this.documentStates.unTrack(PullState.document, document);
					return;
				}
				if (afterState.state === RequestStateKind.outDated) return;
				if (report !== void 0) {
					if (report.kind === vsdiag.DocumentDiagnosticReportKind.full) this.diagnostics.set(uri, report.items);
					documentState.pulledVersion = version;
					documentState.resultId = report.resultId;
				}
				if (afterState.state === RequestStateKind.reschedule) this.pull(document);
			} else if (currentRequestState.state === RequestStateKind.active) {
				currentRequestState.tokenSource.cancel();
				this.openRequests.set(key, {
					state: RequestStateKind.reschedule,
					document: currentRequestState.document
				});
			} else if (currentRequestState.state === RequestStateKind.outDated) this.openRequests.set(key, {
				state: RequestStateKind.reschedule,
				document: currentRequestState.document
			});
		}
		forgetDocument(document) {
			if (this.isDisposed) return;
			const uri = document instanceof vscode_1.Uri ? document : document.uri;
			const key = uri.toString();
			const request = this.openRequests.get(key);
			if (this.options.workspaceDiagnostics && uri.scheme !== "untitled") {
				if (request !== void 0) this.openRequests.set(key, {
					state: RequestStateKind.reschedule,
					document
				});
				else {
					const pendingForget = Symbol();
					this.pendingDocumentForgets.set(key, pendingForget);
					this.pull(document, () => {
						if (this.pendingDocumentForgets.get(key) === pendingForget) {
							this.pendingDocumentForgets.delete(key);
							this.forget(PullState.document, document);
						}
					});
				}
				this.forget(PullState.workspace, document);
			} else {
				if (request !== void 0) {
					if (request.state === RequestStateKind.active) request.tokenSource.cancel();
					this.openRequests.set(key, {
						state: RequestStateKind.outDated,
						document
					});
				}
				this.diagnostics.delete(uri);
				this.forget(PullState.document, document);
			}
		}
		pullWorkspace() {
			if (this.isDisposed) return;
			this.pullWorkspaceAsync().then(() => {
				this.workspaceTimeout = (0, vscode_languageserver_protocol_1.RAL)().timer.setTimeout(() => {
					this.pullWorkspace();
				}, 2e3);
			}, (error) => {
				if (!(error instanceof features_1.LSPCancellationError) && !vscode_languageserver_protocol_1.DiagnosticServerCancellationData.is(error.data)) {
					this.client.error(`Workspace diagnostic pull failed.`, error, false);
					this.workspaceErrorCounter++;
				}
				if (this.workspaceErrorCounter <= 5) this.workspaceTimeout = (0, vscode_languageserver_protocol_1.RAL)().timer.setTimeout(() => {
					this.pullWorkspace();
				}, 2e3);
			});
		}
		async pullWorkspaceAsync() {
			if (!this.provider.provideWorkspaceDiagnostics || this.isDisposed) return;
			if (this.workspaceCancellation !== void 0) {
				this.workspaceCancellation.cancel();
				this.workspaceCancellation = void 0;
			}
			this.workspaceCancellation = new vscode_1.CancellationTokenSource();
			const previousResultIds = this.documentStates.getAllResultIds().map((item) => {
				return {
					uri: this.client.protocol2CodeConverter.asUri(item.uri),
					value: item.value
				};
			});
			await this.provider.provideWorkspaceDiagnostics(previousResultIds, this.workspaceCancellation.token, (chunk) => {
				if (!chunk || this.isDisposed) return;
				for (const item of chunk.items) {
					if (item.kind === vsdiag.DocumentDiagnosticReportKind.full) {
						if (!this.documentStates.tracks(PullState.document, item.uri)) this.diagnostics.set(item.uri, item.items);
					}
					this.documentStates.update(PullState.workspace, item.uri, item.version ?? void 0, item.resultId);
				}
			});
		}
		createProvider() {
			const result = {
				onDidChangeDiagnostics: this.onDidChangeDiagnosticsEmitter.event,
				provideDiagnostics: (document, previousResultId, token) => {
					const provideDiagnostics = (document, previousResultId, token) => {
						const params = {
							identifier: this.options.identifier,
							textDocument: { uri: this.client.code2ProtocolConverter.asUri(document instanceof vscode_1.Uri ? document : document.uri) },
							previousResultId
						};
						if (this.isDisposed === true || !this.client.isRunning()) return {
							kind: vsdiag.DocumentDiagnosticReportKind.full,
							items: []
						};
						return this.client.sendRequest(vscode_languageserver_protocol_1.DocumentDiagnosticRequest.type, params, token).then(async (result) => {
							if (this.isDisposed) return {
								kind: vsdiag.DocumentDiagnosticReportKind.full,
								items: []
							};
							if (token.isCancellationRequested) throw new vscode_1.CancellationError();
							if (result === void 0 || result === null) return {
								kind: vsdiag.DocumentDiagnosticReportKind.full,
								items: []
							};
							if (result.kind === vscode_languageserver_protocol_1.DocumentDiagnosticReportKind.Full) return {
								kind: vsdiag.DocumentDiagnosticReportKind.full,
								resultId: result.resultId,
								items: await this.client.protocol2CodeConverter.asDiagnostics(result.items, token)
							};
							else return {
								kind: vsdiag.DocumentDiagnosticReportKind.unChanged,
								resultId: result.resultId
							};
						}, (error) => {
							return this.client.handleFailedRequest(vscode_languageserver_protocol_1.DocumentDiagnosticRequest.type, token, error, {
								kind: vsdiag.DocumentDiagnosticReportKind.full,
								items: []
							}, true, true);
						});
					};
					const middleware = this.client.middleware;
					return middleware.provideDiagnostics ? middleware.provideDiagnostics(document, previousResultId, token, provideDiagnostics) : provideDiagnostics(document, previousResultId, token);
				}
			};
			if (this.options.workspaceDiagnostics) result.provideWorkspaceDiagnostics = (resultIds, token, resultReporter) => {
				const convertReport = async (report) => {
					if (report.kind === vscode_languageserver_protocol_1.DocumentDiagnosticReportKind.Full) return {
						kind: vsdiag.DocumentDiagnosticReportKind.full,
						uri: this.client.protocol2CodeConverter.asUri(report.uri),
						resultId: report.resultId,
						version: report.version,
						items: await this.client.protocol2CodeConverter.asDiagnostics(report.items, token)
					};
					else return {
						kind: vsdiag.DocumentDiagnosticReportKind.unChanged,
						uri: this.client.protocol2CodeConverter.asUri(report.uri),
						resultId: report.resultId,
						version: report.version
					};
				};
				const convertPreviousResultIds = (resultIds) => {
					const converted = [];
					for (const item of resultIds) converted.push({
						uri: this.client.code2ProtocolConverter.asUri(item.uri),
						value: item.value
					});
					return converted;
				};
				const provideDiagnostics = (resultIds, token, resultReporter) => {
					const partialResultToken = (0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID();
					const disposable = this.client.onProgress(vscode_languageserver_protocol_1.WorkspaceDiagnosticRequest.partialResult, partialResultToken, async (partialResult) => {
						if (partialResult === void 0 || partialResult === null) {
							resultReporter(null);
							return;
						}
						const converted = { items: [] };
						for (const item of partialResult.items) try {
							converted.items.push(await convertReport(item));
						} catch (error) {
							this.client.error(`Converting workspace diagnostics failed.`, error);
						}
						resultReporter(converted);
					});
					const params = {
						identifier: this.options.identifier,
						previousResultIds: convertPreviousResultIds(resultIds),
						partialResultToken
					};
					if (this.isDisposed === true || !this.client.isRunning()) return { items: [] };
					return this.client.sendRequest(vscode_languageserver_protocol_1.WorkspaceDiagnosticRequest.type, params, token).then(async (result) => {
						if (token.isCancellationRequested) return { items: [] };
						const converted = { items: [] };
						for (const item of result.items) converted.items.push(await convertReport(item));
						disposable.dispose();
						resultReporter(converted);
						return { items: [] };
					}, (error) => {
						disposable.dispose();
						return this.client.handleFailedRequest(vscode_languageserver_protocol_1.DocumentDiagnosticRequest.type, token, error, { items: [] });
					});
				};
				const middleware = this.client.middleware;
				return middleware.provideWorkspaceDiagnostics ? middleware.provideWorkspaceDiagnostics(resultIds, token, resultReporter, provideDiagnostics) : provideDiagnostics(resultIds, token, resultReporter);
			};
			return result;
		}
		dispose() {
			this.isDisposed = true;
			this.workspaceCancellation?.cancel();
			this.workspaceTimeout?.dispose();
			for (const [key, request] of this.openRequests) {
				if (request.state === RequestStateKind.active) request.tokenSource.cancel();
				this.openRequests.set(key, {
					state: RequestStateKind.outDated,
					document: request.document
				});
			}
			if (this.client.clientOptions.diagnosticCollectionProvider !== void 0) this.client.clientOptions.diagnosticCollectionProvider.dispose(this.diagnostics, features_1.DiagnosticCollectionSource.pull);
			else this.diagnostics.dispose();
		}
	};
	var BackgroundScheduler = class {
		client;
		diagnosticRequestor;
		lastDocumentToPull;
		documents;
		timeoutHandle;
		isDisposed;
		constructor(client, diagnosticRequestor) {
			this.client = client;
			this.diagnosticRequestor = diagnosticRequestor;
			this.documents = new vscode_languageserver_protocol_1.LinkedMap();
			this.isDisposed = false;
		}
		add(document) {
			if (this.isDisposed === true) return;
			const key = DocumentOrUri.asKey(document);
			if (this.documents.has(key)) return;
			this.documents.set(key, document, vscode_languageserver_protocol_1.Touch.Last);
			this.lastDocumentToPull = document;
		}
		remove(document) {
			const key = DocumentOrUri.asKey(document);
			this.documents.delete(key);
			if (this.documents.size === 0) {
				this.stop();
				return;
			} else if (key === this.lastDocumentToPullKey()) {
				const before = this.documents.before(key);
				if (before === void 0) this.stop();
				else this.lastDocumentToPull = before;
			}
		}
		trigger() {
			this.lastDocumentToPull = this.documents.last;
			this.runLoop();
		}
		runLoop() {
			if (this.isDisposed === true) return;
			if (this.documents.size === 0) {
				this.stop();
				return;
			}
			if (this.lastDocumentToPull === void 0) return;
			if (this.timeoutHandle !== void 0) return;
			this.timeoutHandle = (0, vscode_languageserver_protocol_1.RAL)().timer.setTimeout(() => {
				const document = this.documents.first;
				if (document === void 0) return;
				const key = DocumentOrUri.asKey(document);
				this.diagnosticRequestor.pullAsync(document).catch((error) => {
					this.client.error(`Document pull failed for text document ${key}`, error, false);
				}).finally(() => {
					this.timeoutHandle = void 0;
					this.documents.set(key, document, vscode_languageserver_protocol_1.Touch.Last);
					if (key !== this.lastDocumentToPullKey()) this.runLoop();
				});
			}, 500);
		}
		dispose() {
			this.isDisposed = true;
			this.stop();
			this.documents.clear();
			this.lastDocumentToPull = void 0;
		}
		stop() {
			this.timeoutHandle?.dispose();
			this.timeoutHandle = void 0;
			this.lastDocumentToPull = void 0;
		}
		lastDocumentToPullKey() {
			return this.lastDocumentToPull !== void 0 ? DocumentOrUri.asKey(this.lastDocumentToPull) : void 0;
		}
	};
	var DiagnosticFeatureProviderImpl = class {
		disposable;
		diagnosticRequestor;
		activeTextDocument;
		backgroundScheduler;
		constructor(client, visibleDocuments, options) {
			const diagnosticPullOptions = Object.assign({
				onChange: false,
				onSave: false,
				onFocus: false
			}, client.clientOptions.diagnosticPullOptions);
			const documentSelector = client.protocol2CodeConverter.asDocumentSelector(options.documentSelector);
			const disposables = [];
			const matchFilter = (filter, resource) => {
				if (typeof filter === "string") return false;
				if (filter.language !== void 0 && filter.language !== "*") return false;
				if (filter.scheme !== void 0 && filter.scheme !== "*" && filter.scheme !== resource.scheme) return false;
				if (filter.pattern !== void 0 && !(0, globPattern_1.matchGlobPattern)(filter.pattern, resource)) return false;
				return true;
			};
			const matchResource = (resource) => {
				const selector = options.documentSelector;
				if (diagnosticPullOptions.match !== void 0) return diagnosticPullOptions.match(selector, resource);
				for (const filter of selector) {
					if (!vscode_languageserver_protocol_1.TextDocumentFilter.is(filter)) continue;
					if (matchFilter(filter, resource)) return true;
				}
				return false;
			};
			const matches = (document) => {
				return document instanceof vscode_1.Uri ? matchResource(document) : vscode_1.languages.match(documentSelector, document) > 0 && visibleDocuments.isVisible(document);
			};
			const matchesCell = (cell) => {
				return vscode_1.languages.match(documentSelector, cell.document) > 0 && visibleDocuments.isVisible(cell.notebook.uri);
			};
			const isActiveDocument = (document) => {
				return document instanceof vscode_1.Uri ? this.activeTextDocument?.uri.toString() === document.toString() : this.activeTextDocument === document;
			};
			this.diagnosticRequestor = new DiagnosticRequestor(client, visibleDocuments, options);
			this.backgroundScheduler = new BackgroundScheduler(client, this.diagnosticRequestor);
			const addToBackgroundIfNeeded = (document) => {
				if (!matches(document) || !options.interFileDependencies || isActiveDocument(document) || diagnosticPullOptions.onChange === false) return;
				this.backgroundScheduler.add(document);
			};
			const considerDocument = (textDocument, mode) => {
				return (diagnosticPullOptions.filter === void 0 || !diagnosticPullOptions.filter(textDocument, mode)) && this.diagnosticRequestor.knows(PullState.document, textDocument);
			};
			this.activeTextDocument = vscode_1.window.activeTextEditor?.document;
			disposables.push(vscode_1.window.onDidChangeActiveTextEditor((editor) => {
				const oldActive = this.activeTextDocument;
				this.activeTextDocument = editor?.document;
				if (oldActive !== void 0) addToBackgroundIfNeeded(oldActive);
				if (this.activeTextDocument !== void 0) {
					this.backgroundScheduler.remove(this.activeTextDocument);
					if (diagnosticPullOptions.onFocus === true && matches(this.activeTextDocument) && considerDocument(this.activeTextDocument, DiagnosticPullMode.onFocus)) this.diagnosticRequestor.pull(this.activeTextDocument);
				}
			}));
			const openFeature = client.getFeature(vscode_languageserver_protocol_1.DidOpenTextDocumentNotification.method);
			disposables.push(openFeature.onNotificationSent((event) => {
				const textDocument = event.textDocument;
				if (matches(textDocument)) {
					this.diagnosticRequestor.cancelPendingForget(textDocument);
					if (this.diagnosticRequestor.knowsSameVersion(PullState.document, textDocument)) return;
					this.diagnosticRequestor.pull(textDocument, () => {
						addToBackgroundIfNeeded(textDocument);
					});
				}
			}));
			const notebookFeature = client.getFeature(vscode_languageserver_protocol_1.NotebookDocumentSyncRegistrationType.method);
			disposables.push(notebookFeature.onOpenNotificationSent((event) => {
				for (const cell of event.getCells()) if (matchesCell(cell)) {
					this.diagnosticRequestor.cancelPendingForget(cell.document);
					this.diagnosticRequestor.pull(cell.document, () => {
						addToBackgroundIfNeeded(cell.document);
					});
				}
			}));
			disposables.push(visibleDocuments.onOpen((opened) => {
				for (const resource of opened) {
					if (this.diagnosticRequestor.knows(PullState.document, resource)) continue;
					const uriStr = resource.toString();
					let textDocument;
					for (const item of vscode_1.workspace.textDocuments) if (uriStr === item.uri.toString()) {
						textDocument = item;
						break;
					}
					if (textDocument !== void 0 && matches(textDocument)) this.diagnosticRequestor.pull(textDocument, () => {
						addToBackgroundIfNeeded(textDocument);
					});
				}
			}));
			const pulledTextDocuments = /* @__PURE__ */ new Set();
			for (const textDocument of vscode_1.workspace.textDocuments) if (matches(textDocument)) {
				this.diagnosticRequestor.pull(textDocument, () => {
					addToBackgroundIfNeeded(textDocument);
				});
				pulledTextDocuments.add(textDocument.uri.toString());
			}
			for (const notebookDocument of vscode_1.workspace.notebookDocuments) for (const cell of notebookDocument.getCells()) if (matchesCell(cell)) {
				this.diagnosticRequestor.pull(cell.document, () => {
					addToBackgroundIfNeeded(cell.document);
				});
				pulledTextDocuments.add(cell.document.uri.toString());
			}
			if (diagnosticPullOptions.onTabs === true) {
				for (const resource of visibleDocuments.getResources()) if (!pulledTextDocuments.has(resource.toString()) && matches(resource)) this.diagnosticRequestor.pull(resource, () => {
					addToBackgroundIfNeeded(resource);
				});
			}
			if (diagnosticPullOptions.onChange === true) {
				const changeFeature = client.getFeature(vscode_languageserver_protocol_1.DidChangeTextDocumentNotification.method);
				disposables.push(changeFeature.onNotificationSent(async (event) => {
					const textDocument = event.textDocument;
					if (considerDocument(textDocument, DiagnosticPullMode.onType)) this.diagnosticRequestor.pull(textDocument, () => {
						this.backgroundScheduler.trigger();
					});
				}));
				disposables.push(notebookFeature.onChangeNotificationSent(async (event) => {
					const changedCells = (event.cells?.textContent || []).map((c) => event.notebook.getCells().find((cell) => cell.document.uri.toString() === c.document.uri.toString()));
					const pulledUris = /* @__PURE__ */ new Set();
					for (const cell of changedCells) if (cell && matchesCell(cell)) {
						pulledUris.add(cell.document.uri.toString());
						this.diagnosticRequestor.pull(cell.document, () => {
							this.backgroundScheduler.trigger();
						});
					}
					const closedCells = event.cells?.structure?.didClose || [];
					for (const cell of closedCells) this.diagnosticRequestor.forgetDocument(cell.document);
					const openedCells = event.cells?.structure?.didOpen || [];
					for (const cell of openedCells) if (matchesCell(cell)) {
						pulledUris.add(cell.document.uri.toString());
						this.diagnosticRequestor.pull(cell.document, () => {
							this.backgroundScheduler.trigger();
						});
					}
					if (options.interFileDependencies && event.cells?.structure !== void 0) {
						for (const cell of event.notebook.getCells()) if (matchesCell(cell) && !pulledUris.has(cell.document.uri.toString())) this.diagnosticRequestor.pull(cell.document, () => {
							this.backgroundScheduler.trigger();
						});
					}
				}));
			}
			if (diagnosticPullOptions.onSave === true) {
				const saveFeature = client.getFeature(vscode_languageserver_protocol_1.DidSaveTextDocumentNotification.method);
				disposables.push(saveFeature.onNotificationSent((event) => {
					const textDocument = event.textDocument;
					if (considerDocument(textDocument, DiagnosticPullMode.onSave)) this.diagnosticRequestor.pull(event.textDocument);
				}));
				disposables.push(notebookFeature.onSaveNotificationSent((event) => {
					for (const cell of event.getCells()) if (matchesCell(cell)) this.diagnosticRequestor.pull(cell.document);
				}));
			}
			const closeFeature = client.getFeature(vscode_languageserver_protocol_1.DidCloseTextDocumentNotification.method);
			disposables.push(closeFeature.onAboutToSendNotification((event) => {
				this.cleanUpDocument(event.textDocument);
			}));
			disposables.push(notebookFeature.onCloseNotificationSent((event) => {
				for (const cell of event.getCells()) this.cleanUpDocument(cell.document);
			}));
			disposables.push(visibleDocuments.onClose((closed) => {
				for (const document of closed) this.cleanUpDocument(document);
			}));
			this.diagnosticRequestor.onDidChangeDiagnosticsEmitter.event(() => {
				for (const textDocument of vscode_1.workspace.textDocuments) if (matches(textDocument)) this.diagnosticRequestor.pull(textDocument);
			});
			if (options.workspaceDiagnostics === true && options.identifier !== "da348dc5-c30a-4515-9d98-31ff3be38d14") this.diagnosticRequestor.pullWorkspace();
			this.disposable = vscode_1.Disposable.from(...disposables, this.backgroundScheduler, this.diagnosticRequestor);
		}
		get onDidChangeDiagnosticsEmitter() {
			return this.diagnosticRequestor.onDidChangeDiagnosticsEmitter;
		}
		get diagnostics() {
			return this.diagnosticRequestor.provider;
		}
		forget(document) {
			this.cleanUpDocument(document);
		}
		cleanUpDocument(document) {
			this.backgroundScheduler.remove(document);
			if (this.diagnosticRequestor.knows(PullState.document, document)) this.diagnosticRequestor.forgetDocument(document);
		}
	};
	var DiagnosticFeature = class extends features_1.TextDocumentLanguageFeature {
		constructor(client) {
			super(client, vscode_languageserver_protocol_1.DocumentDiagnosticRequest.type);
		}
		fillClientCapabilities(capabilities) {
			const capability = ensure(ensure(capabilities, "textDocument"), "diagnostic");
			capability.relatedInformation = true;
			capability.tagSupport = { valueSet: [vscode_languageserver_protocol_1.DiagnosticTag.Unnecessary, vscode_languageserver_protocol_1.DiagnosticTag.Deprecated] };
			capability.codeDescriptionSupport = true;
			capability.dataSupport = true;
			capability.dynamicRegistration = true;
			capability.relatedDocumentSupport = false;
			capability.markupMessageSupport = false;
			ensure(ensure(capabilities, "workspace"), "diagnostics").refreshSupport = true;
		}
		initialize(capabilities, documentSelector) {
			this._client.onRequest(vscode_languageserver_protocol_1.DiagnosticRefreshRequest.type, async () => {
				for (const provider of this.getAllProviders()) provider.onDidChangeDiagnosticsEmitter.fire();
			});
			const [id, options] = this.getRegistration(documentSelector, capabilities.diagnosticProvider);
			if (!id || !options) return;
			this.register({
				id,
				registerOptions: options
			});
		}
		clear() {
			super.clear();
		}
		refresh() {
			for (const provider of this.getAllProviders()) provider.onDidChangeDiagnosticsEmitter.fire();
		}
		registerLanguageProvider(options) {
			const provider = new DiagnosticFeatureProviderImpl(this._client, this._client.visibleDocuments, options);
			return [provider.disposable, provider];
		}
	};
	exports.DiagnosticFeature = DiagnosticFeature;
}));
// node_modules/vscode-languageclient/lib/common/notebook.js
var require_notebook = /* @__PURE__ */ __commonJSMin(((exports, module, this$13) => {
	var __createBinding = this$13 && this$13.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$13 && this$13.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$13 && this$13.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.NotebookDocumentSyncFeature = void 0;
	var vscode = __importStar(require("vscode"));
	var proto = __importStar(require_api$1());
	var vscode_languageserver_protocol_1 = require_api$1();
	var Is = __importStar(require_is$2());
	var globPattern_1 = require_globPattern();
	function ensure(target, key) {
		if (target[key] === void 0) target[key] = {};
		return target[key];
	}
	var Converter;
	(function(Converter) {
		(function(c2p) {
			function asVersionedNotebookDocumentIdentifier(notebookDocument, base) {
				return {
					version: notebookDocument.version,
					uri: base.asUri(notebookDocument.uri)
				};
			}
			c2p.asVersionedNotebookDocumentIdentifier = asVersionedNotebookDocumentIdentifier;
			function asNotebookDocument(notebookDocument, cells, base) {
				const result = proto.NotebookDocument.create(base.asUri(notebookDocument.uri), notebookDocument.notebookType, notebookDocument.version, asNotebookCells(cells, base));
				if (Object.keys(notebookDocument.metadata).length > 0) result.metadata = asMetadata(notebookDocument.metadata);
				return result;
			}
			c2p.asNotebookDocument = asNotebookDocument;
			function asNotebookCells(cells, base) {
				return cells.map((cell) => asNotebookCell(cell, base));
			}
			c2p.asNotebookCells = asNotebookCells;
			function asMetadata(metadata) {
				return deepCopy(/* @__PURE__ */ new Set(), metadata);
			}
			c2p.asMetadata = asMetadata;
			function asNotebookCell(cell, base) {
				const result = proto.NotebookCell.create(asNotebookCellKind(cell.kind), base.asUri(cell.document.uri));
				if (Object.keys(cell.metadata).length > 0) result.metadata = asMetadata(cell.metadata);
				if (cell.executionSummary !== void 0 && Is.number(cell.executionSummary.executionOrder) && Is.boolean(cell.executionSummary.success)) result.executionSummary = {
					executionOrder: cell.executionSummary.executionOrder,
					success: cell.executionSummary.success
				};
				return result;
			}
			c2p.asNotebookCell = asNotebookCell;
			function asNotebookCellKind(kind) {
				switch (kind) {
					case vscode.NotebookCellKind.Markup: return proto.NotebookCellKind.Markup;
					case vscode.NotebookCellKind.Code: return proto.NotebookCellKind.Code;
				}
			}
			function deepCopy(seen, value) {
				if (seen.has(value)) throw new Error(`Can't deep copy cyclic structures.`);
				if (Array.isArray(value)) {
					const result = [];
					for (const elem of value) if (elem !== null && typeof elem === "object" || Array.isArray(elem)) result.push(deepCopy(seen, elem));
					else {
						if (elem instanceof RegExp) throw new Error(`Can't transfer regular expressions to the server`);
						result.push(elem);
					}
					return result;
				} else {
					const props = Object.keys(value);
					const result = Object.create(null);
					for (const prop of props) {
						const elem = value[prop];
						if (elem !== null && typeof elem === "object" || Array.isArray(elem)) result[prop] = deepCopy(seen, elem);
						else {
							if (elem instanceof RegExp) throw new Error(`Can't transfer regular expressions to the server`);
							result[prop] = elem;
						}
					}
					return result;
				}
			}
			function asTextContentChange(event, base) {
				const params = base.asChangeTextDocumentParams(event, event.document.uri, event.document.version);
				return {
					document: params.textDocument,
					changes: params.contentChanges
				};
			}
			c2p.asTextContentChange = asTextContentChange;
			function asNotebookDocumentChangeEvent(event, base) {
				const result = Object.create(null);
				if (event.metadata) result.metadata = Converter.c2p.asMetadata(event.metadata);
				if (event.cells !== void 0) {
					const cells = Object.create(null);
					const changedCells = event.cells;
					if (changedCells.structure) cells.structure = {
						array: {
							start: changedCells.structure.array.start,
							deleteCount: changedCells.structure.array.deleteCount,
							cells: changedCells.structure.array.cells !== void 0 ? changedCells.structure.array.cells.map((cell) => Converter.c2p.asNotebookCell(cell, base)) : void 0
						},
						didOpen: changedCells.structure.didOpen !== void 0 ? changedCells.structure.didOpen.map((cell) => base.asOpenTextDocumentParams(cell.document).textDocument) : void 0,
						didClose: changedCells.structure.didClose !== void 0 ? changedCells.structure.didClose.map((cell) => base.asCloseTextDocumentParams(cell.document).textDocument) : void 0
					};
					if (changedCells.data !== void 0) cells.data = changedCells.data.map((cell) => Converter.c2p.asNotebookCell(cell, base));
					if (changedCells.textContent !== void 0) cells.textContent = changedCells.textContent.map((event) => Converter.c2p.asTextContentChange(event, base));
					if (Object.keys(cells).length > 0) result.cells = cells;
				}
				return result;
			}
			c2p.asNotebookDocumentChangeEvent = asNotebookDocumentChangeEvent;
		})(Converter.c2p || (Converter.c2p = {}));
	})(Converter || (Converter = {}));
	var $NotebookCell;
	(function($NotebookCell) {
		function computeDiff(originalCells, modifiedCells, compareMetadata) {
			const originalLength = originalCells.length;
			const modifiedLength = modifiedCells.length;
			let startIndex = 0;
			while (startIndex < modifiedLength && startIndex < originalLength && equals(originalCells[startIndex], modifiedCells[startIndex], compareMetadata)) startIndex++;
			if (startIndex < modifiedLength && startIndex < originalLength) {
				let originalEndIndex = originalLength - 1;
				let modifiedEndIndex = modifiedLength - 1;
				while (originalEndIndex >= 0 && modifiedEndIndex >= 0 && equals(originalCells[originalEndIndex], modifiedCells[modifiedEndIndex], compareMetadata)) {
					originalEndIndex--;
					modifiedEndIndex--;
				}
				const deleteCount = originalEndIndex + 1 - startIndex;
				const newCells = startIndex === modifiedEndIndex + 1 ? void 0 : modifiedCells.slice(startIndex, modifiedEndIndex + 1);
				return newCells !== void 0 ? {
					start: startIndex,
					deleteCount,
					cells: newCells
				} : {
					start: startIndex,
					deleteCount
				};
			} else if (startIndex < modifiedLength) return {
				start: startIndex,
				deleteCount: 0,
				cells: modifiedCells.slice(startIndex)
			};
			else if (startIndex < originalLength) return {
				start: startIndex,
				deleteCount: originalLength - startIndex
			};
			else return;
		}
		$NotebookCell.computeDiff = computeDiff;
		/**
		* We only sync kind, document, execution and metadata to the server. So we only need to compare those.
		*/
		function equals(one, other, compareMetaData = true) {
			if (one.kind !== other.kind || one.document.uri.toString() !== other.document.uri.toString() || one.document.languageId !== other.document.languageId || !equalsExecution(one.executionSummary, other.executionSummary)) return false;
			return !compareMetaData || compareMetaData && equalsMetadata(one.metadata, other.metadata);
		}
		function equalsExecution(one, other) {
			if (one === other) return true;
			if (one === void 0 || other === void 0) return false;
			return one.executionOrder === other.executionOrder && one.success === other.success && equalsTiming(one.timing, other.timing);
		}
		function equalsTiming(one, other) {
			if (one === other) return true;
			if (one === void 0 || other === void 0) return false;
			return one.startTime === other.startTime && one.endTime === other.endTime;
		}
		function equalsMetadata(one, other) {
			if (one === other) return true;
			if (one === null || one === void 0 || other === null || other === void 0) return false;
			if (typeof one !== typeof other) return false;
			if (typeof one !== "object") return false;
			const oneArray = Array.isArray(one);
			const otherArray = Array.isArray(other);
			if (oneArray !== otherArray) return false;
			if (oneArray && otherArray) {
				if (one.length !== other.length) return false;
				for (let i = 0; i < one.length; i++) if (!equalsMetadata(one[i], other[i])) return false;
			}
			if (isObjectLiteral(one) && isObjectLiteral(other)) {
				const oneKeys = Object.keys(one);
				const otherKeys = Object.keys(other);
				if (oneKeys.length !== otherKeys.length) return false;
				oneKeys.sort();
				otherKeys.sort();
				if (!equalsMetadata(oneKeys, otherKeys)) return false;
				for (let i = 0; i < oneKeys.length; i++) {
					const prop = oneKeys[i];
					if (!equalsMetadata(one[prop], other[prop])) return false;
				}
				return true;
			}
			return false;
		}
		function isObjectLiteral(value) {
			return value !== null && typeof value === "object";
		}
		$NotebookCell.isObjectLiteral = isObjectLiteral;
	})($NotebookCell || ($NotebookCell = {}));
	var $NotebookDocumentFilter;
	(function($NotebookDocumentFilter) {
		function matchNotebook(filter, notebookDocument) {
			if (typeof filter === "string") return filter === "*" || notebookDocument.notebookType === filter;
			if (filter.notebookType !== void 0 && filter.notebookType !== "*" && notebookDocument.notebookType !== filter.notebookType) return false;
			const uri = notebookDocument.uri;
			if (filter.scheme !== void 0 && filter.scheme !== "*" && uri.scheme !== filter.scheme) return false;
			if (filter.pattern !== void 0) {
				if (!(0, globPattern_1.matchGlobPattern)(filter.pattern, uri)) return false;
			}
			return true;
		}
		$NotebookDocumentFilter.matchNotebook = matchNotebook;
	})($NotebookDocumentFilter || ($NotebookDocumentFilter = {}));
	var $NotebookDocumentSyncOptions;
	(function($NotebookDocumentSyncOptions) {
		function asDocumentSelector(options) {
			const selector = options.notebookSelector;
			const result = [];
			for (const element of selector) {
				const notebookType = (typeof element.notebook === "string" ? element.notebook : element.notebook?.notebookType) ?? "*";
				const scheme = typeof element.notebook === "string" ? void 0 : element.notebook?.scheme;
				const pattern = typeof element.notebook === "string" ? void 0 : element.notebook?.pattern;
				if (element.cells !== void 0) for (const cell of element.cells) result.push(asDocumentFilter(notebookType, scheme, pattern, cell.language));
				else result.push(asDocumentFilter(notebookType, scheme, pattern, void 0));
			}
			return result;
		}
		$NotebookDocumentSyncOptions.asDocumentSelector = asDocumentSelector;
		function asDocumentFilter(notebookType, scheme, pattern, language) {
			return scheme === void 0 && pattern === void 0 ? {
				notebook: notebookType,
				language
			} : {
				notebook: {
					notebookType,
					scheme,
					pattern
				},
				language
			};
		}
	})($NotebookDocumentSyncOptions || ($NotebookDocumentSyncOptions = {}));
	var SyncInfo;
	(function(SyncInfo) {
		function create(cells) {
			return {
				cells,
				uris: new Set(cells.map((cell) => cell.document.uri.toString()))
			};
		}
		SyncInfo.create = create;
	})(SyncInfo || (SyncInfo = {}));
	var NotebookDocumentSyncFeatureProvider = class {
		client;
		options;
		notebookSyncInfo;
		notebookDidOpen;
		disposables;
		selector;
		onChangeNotificationSent;
		onOpenNotificationSent;
		onCloseNotificationSent;
		onSaveNotificationSent;
		constructor(client, options, onChangeNotificationSent, onOpenNotificationSent, onCloseNotificationSent, onSaveNotificationSent) {
			this.client = client;
			this.options = options;
			this.notebookSyncInfo = /* @__PURE__ */ new Map();
			this.notebookDidOpen = /* @__PURE__ */ new Set();
			this.disposables = [];
			this.selector = client.protocol2CodeConverter.asDocumentSelector($NotebookDocumentSyncOptions.asDocumentSelector(options));
			this.onChangeNotificationSent = onChangeNotificationSent;
			this.onOpenNotificationSent = onOpenNotificationSent;
			this.onCloseNotificationSent = onCloseNotificationSent;
			this.onSaveNotificationSent = onSaveNotificationSent;
			vscode.workspace.onDidOpenNotebookDocument((notebookDocument) => {
				this.notebookDidOpen.add(notebookDocument.uri.toString());
				this.didOpen(notebookDocument);
			}, void 0, this.disposables);
			for (const notebookDocument of vscode.workspace.notebookDocuments) {
				this.notebookDidOpen.add(notebookDocument.uri.toString());
				this.didOpen(notebookDocument);
			}
			vscode.workspace.onDidChangeNotebookDocument((event) => this.didChangeNotebookDocument(event), void 0, this.disposables);
			if (this.options.save === true) vscode.workspace.onDidSaveNotebookDocument((notebookDocument) => this.didSave(notebookDocument), void 0, this.disposables);
			vscode.workspace.onDidCloseNotebookDocument((notebookDocument) => {
				this.didClose(notebookDocument);
				this.notebookDidOpen.delete(notebookDocument.uri.toString());
			}, void 0, this.disposables);
		}
		getState() {
			for (const notebook of vscode.workspace.notebookDocuments) if (this.getMatchingCellsConsideringSyncInfo(notebook) !== void 0) return {
				kind: "document",
				id: "$internal",
				registrations: true,
				matches: true
			};
			return {
				kind: "document",
				id: "$internal",
				registrations: true,
				matches: false
			};
		}
		get mode() {
			return "notebook";
		}
		handles(textDocument) {
			if (vscode.languages.match(this.selector, textDocument) > 0) return true;
			const key = textDocument.uri.toString();
			for (const syncInfo of this.notebookSyncInfo.values()) if (syncInfo.uris.has(key)) return true;
			return false;
		}
		didOpenNotebookCellTextDocument(notebookDocument, cell) {
			if (vscode.languages.match(this.selector, cell.document) === 0) return;
			if (!this.notebookDidOpen.has(notebookDocument.uri.toString())) return;
			const syncInfo = this.getSyncInfo(notebookDocument);
			const cellMatches = this.cellMatches(notebookDocument, cell);
			if (syncInfo !== void 0) {
				const cellIsSynced = syncInfo.uris.has(cell.document.uri.toString());
				if (cellMatches && cellIsSynced || !cellMatches && !cellIsSynced) return;
				if (cellMatches) {
					const matchingCells = this.mergeCells(notebookDocument, syncInfo, [cell]);
					if (matchingCells !== void 0) {
						const event = this.asNotebookDocumentChangeEvent(notebookDocument, void 0, syncInfo, matchingCells);
						if (event !== void 0) this.doSendChange(event, matchingCells).catch(() => {});
					}
				}
			} else if (cellMatches) this.doSendOpen(notebookDocument, [cell]).catch(() => {});
		}
		didChangeNotebookCellTextDocument(notebookDocument, cell, event) {
			if (vscode.languages.match(this.selector, event.document) === 0) return;
			const syncInfo = this.getSyncInfo(notebookDocument);
			if (syncInfo === void 0 || !syncInfo.uris.has(cell.document.uri.toString())) return;
			this.doSendChange({
				notebook: notebookDocument,
				cells: { textContent: [event] }
			}, syncInfo.cells).catch(() => {});
		}
		didCloseNotebookCellTextDocument(notebookDocument, cell) {
			const syncInfo = this.getSyncInfo(notebookDocument);
			if (syncInfo === void 0) return;
			const cellUri = cell.document.uri;
			const index = syncInfo.cells.findIndex((item) => item.document.uri.toString() === cellUri.toString());
			if (index === -1) return;
			if (index === 0 && syncInfo.cells.length === 1) this.doSendClose(notebookDocument, syncInfo.cells).catch(() => {});
			else {
				const newCells = syncInfo.cells.slice();
				const deleted = newCells.splice(index, 1);
				this.doSendChange({
					notebook: notebookDocument,
					cells: { structure: {
						array: {
							start: index,
							deleteCount: 1
						},
						didClose: deleted
					} }
				}, newCells).catch(() => {});
			}
		}
		dispose() {
			for (const disposable of this.disposables) disposable.dispose();
		}
		didOpen(notebookDocument, matchingCells, syncInfo = this.getSyncInfo(notebookDocument)) {
			if (syncInfo !== void 0) {
				if (matchingCells === void 0) matchingCells = syncInfo.cells.slice();
				if (matchingCells !== void 0) {
					const event = this.asNotebookDocumentChangeEvent(notebookDocument, void 0, syncInfo, matchingCells);
					if (event !== void 0) this.doSendChange(event, matchingCells).catch(() => {});
				} else this.doSendClose(notebookDocument, []).catch(() => {});
			} else {
				matchingCells = this.getMatchingCells(notebookDocument);
				if (matchingCells === void 0) return;
				this.doSendOpen(notebookDocument, matchingCells).catch(() => {});
			}
		}
		didChangeNotebookDocument(event) {
			const notebookDocument = event.notebook;
			const syncInfo = this.getSyncInfo(notebookDocument);
			if (syncInfo === void 0) {
				if (event.contentChanges.length === 0) return;
				const cells = this.getMatchingCells(notebookDocument);
				if (cells === void 0) return;
				this.didOpen(notebookDocument, cells, syncInfo);
			} else {
				const cells = this.getMatchingCellsFromEvent(notebookDocument, syncInfo, event);
				if (cells === void 0) {
					this.didClose(notebookDocument, syncInfo);
					return;
				}
				const newEvent = this.asNotebookDocumentChangeEvent(event.notebook, event, syncInfo, cells);
				if (newEvent !== void 0) this.doSendChange(newEvent, cells).catch(() => {});
			}
		}
		didSave(notebookDocument) {
			if (this.getSyncInfo(notebookDocument) === void 0) return;
			this.doSendSave(notebookDocument).catch(() => {});
		}
		didClose(notebookDocument, syncInfo = this.getSyncInfo(notebookDocument)) {
			if (syncInfo === void 0) return;
			const syncedCells = notebookDocument.getCells().filter((cell) => syncInfo.uris.has(cell.document.uri.toString()));
			this.doSendClose(notebookDocument, syncedCells).catch(() => {});
		}
		async sendDidOpenNotebookDocument(notebookDocument) {
			if (this.getSyncInfo(notebookDocument) !== void 0) throw new Error(`Notebook document ${notebookDocument.uri.toString()} is already open`);
			const cells = this.getMatchingCells(notebookDocument);
			if (cells === void 0) return;
			return this.doSendOpen(notebookDocument, cells);
		}
		async doSendOpen(notebookDocument, cells) {
			const send = async (notebookDocument, cells) => {
				const cellDocuments = cells.map((cell) => this.client.code2ProtocolConverter.asTextDocumentItem(cell.document));
				try {
					await this.client.sendNotification(proto.DidOpenNotebookDocumentNotification.type, {
						notebookDocument: Converter.c2p.asNotebookDocument(notebookDocument, cells, this.client.code2ProtocolConverter),
						cellTextDocuments: cellDocuments
					});
					this.onOpenNotificationSent.fire(notebookDocument);
				} catch (error) {
					this.client.error("Sending DidOpenNotebookDocumentNotification failed", error);
					throw error;
				}
			};
			const middleware = this.client.middleware?.notebooks;
			this.notebookSyncInfo.set(notebookDocument.uri.toString(), SyncInfo.create(cells));
			return middleware?.didOpen !== void 0 ? middleware.didOpen(notebookDocument, cells, send) : send(notebookDocument, cells);
		}
		async sendDidChangeNotebookDocument(event) {
			const cells = this.getMatchingCellsFromSyncInfo(event.notebook);
			if (cells === void 0) throw new Error(`Received changed event for un-synced notebook ${event.notebook.uri.toString()}`);
			return this.doSendChange(event, cells);
		}
		async doSendChange(event, cells) {
			const send = async (event) => {
				try {
					await this.client.sendNotification(proto.DidChangeNotebookDocumentNotification.type, {
						notebookDocument: Converter.c2p.asVersionedNotebookDocumentIdentifier(event.notebook, this.client.code2ProtocolConverter),
						change: Converter.c2p.asNotebookDocumentChangeEvent(event, this.client.code2ProtocolConverter)
					});
					this.onChangeNotificationSent.fire(event);
				} catch (error) {
					this.client.error("Sending DidChangeNotebookDocumentNotification failed", error);
					throw error;
				}
			};
			const middleware = this.client.middleware?.notebooks;
			if (event.cells?.structure !== void 0) this.notebookSyncInfo.set(event.notebook.uri.toString(), SyncInfo.create(cells));
			return middleware?.didChange !== void 0 ? middleware?.didChange(event, send) : send(event);
		}
		async sendDidSaveNotebookDocument(notebookDocument) {
			return this.doSendSave(notebookDocument);
		}
		async doSendSave(notebookDocument) {
			const send = async (notebookDocument) => {
				try {
					await this.client.sendNotification(proto.DidSaveNotebookDocumentNotification.type, { notebookDocument: { uri: this.client.code2ProtocolConverter.asUri(notebookDocument.uri) } });
					this.onSaveNotificationSent.fire(notebookDocument);
				} catch (error) {
					this.client.error("Sending DidSaveNotebookDocumentNotification failed", error);
					throw error;
				}
			};
			const middleware = this.client.middleware?.notebooks;
			return middleware?.didSave !== void 0 ? middleware.didSave(notebookDocument, send) : send(notebookDocument);
		}
		async sendDidCloseNotebookDocument(notebookDocument) {
			const cells = this.getMatchingCellsFromSyncInfo(notebookDocument);
			if (cells === void 0) throw new Error(`Received close event for un-synced notebook ${notebookDocument.uri.toString()}`);
			return this.doSendClose(notebookDocument, cells);
		}
		async doSendClose(notebookDocument, cells) {
			const send = async (notebookDocument, cells) => {
				try {
					await this.client.sendNotification(proto.DidCloseNotebookDocumentNotification.type, {
						notebookDocument: { uri: this.client.code2ProtocolConverter.asUri(notebookDocument.uri) },
						cellTextDocuments: cells.map((cell) => this.client.code2ProtocolConverter.asTextDocumentIdentifier(cell.document))
					});
					this.onCloseNotificationSent.fire(notebookDocument);
				} catch (error) {
					this.client.error("Sending DidCloseNotebookDocumentNotification failed", error);
					throw error;
				}
			};
			const middleware = this.client.middleware?.notebooks;
			this.notebookSyncInfo.delete(notebookDocument.uri.toString());
			return middleware?.didClose !== void 0 ? middleware.didClose(notebookDocument, cells, send) : send(notebookDocument, cells);
		}
		getSynchronizedCells(notebookDocument) {
			return this.getSyncInfo(notebookDocument)?.cells;
		}
		asNotebookDocumentChangeEvent(notebook, event, syncInfo, matchingCells) {
			if (event !== void 0 && event.notebook !== notebook) throw new Error("Notebook must be identical");
			const result = { notebook };
			if (event?.metadata !== void 0) result.metadata = Converter.c2p.asMetadata(event.metadata);
			let matchingCellsSet;
			if (event?.cellChanges !== void 0 && event.cellChanges.length > 0) {
				const data = [];
				matchingCellsSet = new Set(matchingCells.map((cell) => cell.document.uri.toString()));
				for (const cellChange of event.cellChanges) if (matchingCellsSet.has(cellChange.cell.document.uri.toString()) && (cellChange.executionSummary !== void 0 || cellChange.metadata !== void 0)) data.push(cellChange.cell);
				if (data.length > 0) {
					result.cells = result.cells ?? {};
					result.cells.data = data;
				}
			}
			if ((event?.contentChanges !== void 0 && event.contentChanges.length > 0 || event === void 0) && syncInfo !== void 0 && matchingCells !== void 0) {
				const oldCells = syncInfo.cells;
				const newCells = matchingCells;
				const diff = $NotebookCell.computeDiff(oldCells, newCells, false);
				let addedCells;
				let removedCells;
				if (diff !== void 0) {
					addedCells = diff.cells === void 0 ? /* @__PURE__ */ new Map() : new Map(diff.cells.map((cell) => [cell.document.uri.toString(), cell]));
					removedCells = diff.deleteCount === 0 ? /* @__PURE__ */ new Map() : new Map(oldCells.slice(diff.start, diff.start + diff.deleteCount).map((cell) => [cell.document.uri.toString(), cell]));
					for (const key of Array.from(removedCells.keys())) if (addedCells.has(key)) {
						removedCells.delete(key);
						addedCells.delete(key);
					}
					result.cells = result.cells ?? {};
					const didOpen = [];
					const didClose = [];
					if (addedCells.size > 0 || removedCells.size > 0) {
						for (const cell of addedCells.values()) didOpen.push(cell);
						for (const cell of removedCells.values()) didClose.push(cell);
					}
					result.cells.structure = {
						array: diff,
						didOpen,
						didClose
					};
				}
			}
			return Object.keys(result).length > 1 ? result : void 0;
		}
		getMatchingCells(notebookDocument, cells = notebookDocument.getCells()) {
			if (this.options.notebookSelector === void 0) return;
			for (const item of this.options.notebookSelector) if (item.notebook === void 0 || $NotebookDocumentFilter.matchNotebook(item.notebook, notebookDocument)) {
				const filtered = this.filterCells(notebookDocument, cells, item.cells);
				return filtered.length === 0 ? void 0 : filtered;
			}
		}
		getMatchingCellsFromEvent(notebookDocument, syncInfo, event) {
			if (this.options.notebookSelector === void 0) return;
			let selector;
			for (const item of this.options.notebookSelector) if (item.notebook === void 0 || $NotebookDocumentFilter.matchNotebook(item.notebook, notebookDocument)) {
				selector = item;
				break;
			}
			if (selector === void 0) return;
			if ((event.cellChanges === void 0 || event.cellChanges.length === 0) && (event.contentChanges === void 0 || event.contentChanges.length === 0)) return syncInfo.cells;
			let cells;
			if (event.cellChanges !== void 0 && event.cellChanges.length > 0) {
				const changedCells = event.cellChanges.map((item) => item.cell);
				const filtered = this.filterCells(notebookDocument, changedCells, selector.cells);
				if (filtered.length !== changedCells.length) {
					cells = new Set(syncInfo.uris);
					for (const cell of changedCells) cells.delete(cell.document.uri.toString());
					for (const cell of filtered) cells.add(cell.document.uri.toString());
				}
			}
			if (event.contentChanges !== void 0 && event.contentChanges.length > 0) {
				if (cells === void 0) cells = new Set(syncInfo.uris);
				for (const item of event.contentChanges) {
					for (const cell of item.removedCells) cells.delete(cell.document.uri.toString());
					const filtered = this.filterCells(notebookDocument, new Array(...item.addedCells), selector.cells);
					for (const cell of filtered) cells.add(cell.document.uri.toString());
				}
			}
			if (cells === void 0) return syncInfo.cells;
			const result = [];
			const current = notebookDocument.getCells();
			for (const cell of current) if (cells.has(cell.document.uri.toString())) result.push(cell);
			return result;
		}
		getMatchingCellsFromSyncInfo(notebook) {
			const syncInfo = this.getSyncInfo(notebook);
			return syncInfo !== void 0 ? syncInfo.cells : void 0;
		}
		getMatchingCellsConsideringSyncInfo(notebook) {
			const syncInfo = this.getSyncInfo(notebook);
			return syncInfo !== void 0 ? syncInfo.cells : this.getMatchingCells(notebook);
		}
		mergeCells(notebookDocument, syncInfo, cells) {
			const result = [];
			const merged = new Set(syncInfo.uris);
			for (const cell of cells) merged.add(cell.document.uri.toString());
			for (const cell of notebookDocument.getCells()) if (merged.has(cell.document.uri.toString())) result.push(cell);
			return result;
		}
		cellMatches(notebookDocument, cell) {
			const cells = this.getMatchingCells(notebookDocument, [cell]);
			return cells !== void 0 && cells[0] === cell;
		}
		filterCells(notebookDocument, cells, cellSelector) {
			const filtered = cellSelector !== void 0 ? cells.filter((cell) => {
				const cellLanguage = cell.document.languageId;
				return cellSelector.some(((filter) => filter.language === "*" || cellLanguage === filter.language));
			}) : cells;
			return typeof this.client.clientOptions.notebookDocumentOptions?.filterCells === "function" ? this.client.clientOptions.notebookDocumentOptions.filterCells(notebookDocument, filtered) : filtered;
		}
		getSyncInfo(notebook) {
			return this.notebookSyncInfo.get(notebook.uri.toString());
		}
	};
	exports.NotebookDocumentSyncFeature = class NotebookDocumentSyncFeature {
		static CellScheme = "vscode-notebook-cell";
		client;
		registrations;
		dedicatedChannel;
		_onChangeNotificationSent;
		_onOpenNotificationSent;
		_onCloseNotificationSent;
		_onSaveNotificationSent;
		constructor(client) {
			this.client = client;
			this.registrations = /* @__PURE__ */ new Map();
			this.registrationType = proto.NotebookDocumentSyncRegistrationType.type;
			this._onChangeNotificationSent = new vscode.EventEmitter();
			this._onOpenNotificationSent = new vscode.EventEmitter();
			this._onCloseNotificationSent = new vscode.EventEmitter();
			this._onSaveNotificationSent = new vscode.EventEmitter();
			vscode.workspace.onDidOpenTextDocument((textDocument) => {
				if (textDocument.uri.scheme !== NotebookDocumentSyncFeature.CellScheme) return;
				const [notebookDocument, notebookCell] = this.findNotebookDocumentAndCell(textDocument);
				if (notebookDocument === void 0 || notebookCell === void 0) return;
				for (const provider of this.registrations.values()) if (provider instanceof NotebookDocumentSyncFeatureProvider) provider.didOpenNotebookCellTextDocument(notebookDocument, notebookCell);
			});
			vscode.workspace.onDidChangeTextDocument((event) => {
				if (event.contentChanges.length === 0) return;
				const textDocument = event.document;
				if (textDocument.uri.scheme !== NotebookDocumentSyncFeature.CellScheme) return;
				const [notebookDocument, cell] = this.findNotebookDocumentAndCell(textDocument);
				if (notebookDocument === void 0 || cell === void 0) return;
				for (const provider of this.registrations.values()) if (provider instanceof NotebookDocumentSyncFeatureProvider) provider.didChangeNotebookCellTextDocument(notebookDocument, cell, event);
			});
			vscode.workspace.onDidCloseTextDocument((textDocument) => {
				if (textDocument.uri.scheme !== NotebookDocumentSyncFeature.CellScheme) return;
				const [notebookDocument, notebookCell] = this.findNotebookDocumentAndCell(textDocument);
				if (notebookDocument === void 0 || notebookCell === void 0) return;
				for (const provider of this.registrations.values()) if (provider instanceof NotebookDocumentSyncFeatureProvider) provider.didCloseNotebookCellTextDocument(notebookDocument, notebookCell);
			});
		}
		getState() {
			if (this.registrations.size === 0) return {
				kind: "document",
				id: this.registrationType.method,
				registrations: false,
				matches: false
			};
			for (const provider of this.registrations.values()) {
				const state = provider.getState();
				if (state.kind === "document" && state.registrations === true && state.matches === true) return {
					kind: "document",
					id: this.registrationType.method,
					registrations: true,
					matches: true
				};
			}
			return {
				kind: "document",
				id: this.registrationType.method,
				registrations: true,
				matches: false
			};
		}
		registrationType;
		get onOpenNotificationSent() {
			return this._onOpenNotificationSent.event;
		}
		get onChangeNotificationSent() {
			return this._onChangeNotificationSent.event;
		}
		get onCloseNotificationSent() {
			return this._onCloseNotificationSent.event;
		}
		get onSaveNotificationSent() {
			return this._onSaveNotificationSent.event;
		}
		fillClientCapabilities(capabilities) {
			const synchronization = ensure(ensure(capabilities, "notebookDocument"), "synchronization");
			synchronization.dynamicRegistration = true;
			synchronization.executionSummarySupport = true;
		}
		preInitialize(capabilities) {
			const options = capabilities.notebookDocumentSync;
			if (options === void 0) return;
			this.dedicatedChannel = this.client.protocol2CodeConverter.asDocumentSelector($NotebookDocumentSyncOptions.asDocumentSelector(options));
		}
		initialize(capabilities) {
			const options = capabilities.notebookDocumentSync;
			if (options === void 0) return;
			const id = options.id ?? (0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID();
			this.register({
				id,
				registerOptions: options
			});
		}
		register(data) {
			const provider = new NotebookDocumentSyncFeatureProvider(this.client, data.registerOptions, this._onChangeNotificationSent, this._onOpenNotificationSent, this._onCloseNotificationSent, this._onSaveNotificationSent);
			this.registrations.set(data.id, provider);
		}
		unregister(id) {
			const provider = this.registrations.get(id);
			if (provider !== void 0) {
				this.registrations.delete(id);
				provider.dispose();
			}
		}
		clear() {
			for (const provider of this.registrations.values()) provider.dispose();
			this.registrations.clear();
			this._onChangeNotificationSent.dispose();
			this._onChangeNotificationSent = new vscode.EventEmitter();
			this._onOpenNotificationSent.dispose();
			this._onOpenNotificationSent = new vscode.EventEmitter();
			this._onCloseNotificationSent.dispose();
			this._onCloseNotificationSent = new vscode.EventEmitter();
			this._onSaveNotificationSent.dispose();
			this._onSaveNotificationSent = new vscode.EventEmitter();
		}
		handles(textDocument) {
			if (textDocument.uri.scheme !== NotebookDocumentSyncFeature.CellScheme) return false;
			if (this.dedicatedChannel !== void 0 && vscode.languages.match(this.dedicatedChannel, textDocument) > 0) return true;
			for (const provider of this.registrations.values()) if (provider.handles(textDocument)) return true;
			return false;
		}
		getProvider(notebookCell) {
			for (const provider of this.registrations.values()) if (provider.handles(notebookCell.document)) return provider;
		}
		findNotebookDocumentAndCell(textDocument) {
			const uri = textDocument.uri.toString();
			for (const notebookDocument of vscode.workspace.notebookDocuments) for (const cell of notebookDocument.getCells()) if (cell.document.uri.toString() === uri) return [notebookDocument, cell];
			return [void 0, void 0];
		}
	};
}));
// node_modules/vscode-languageclient/lib/common/configuration.js
var require_configuration = /* @__PURE__ */ __commonJSMin(((exports, module, this$12) => {
	var __createBinding = this$12 && this$12.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$12 && this$12.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$12 && this$12.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.SyncConfigurationFeature = exports.ConfigurationFeature = void 0;
	exports.toJSONObject = toJSONObject;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var Is = __importStar(require_is$2());
	var features_1 = require_features();
	/**
	* Configuration pull model. From server to client.
	*/
	var ConfigurationFeature = class {
		_client;
		constructor(client) {
			this._client = client;
		}
		getState() {
			return { kind: "static" };
		}
		fillClientCapabilities(capabilities) {
			capabilities.workspace = capabilities.workspace || {};
			capabilities.workspace.configuration = true;
		}
		initialize() {
			const client = this._client;
			client.onRequest(vscode_languageserver_protocol_1.ConfigurationRequest.type, (params, token) => {
				const configuration = (params) => {
					const result = [];
					for (const item of params.items) {
						const resource = item.scopeUri !== void 0 && item.scopeUri !== null ? this._client.protocol2CodeConverter.asUri(item.scopeUri) : void 0;
						result.push(this.getConfiguration(resource, item.section !== null ? item.section : void 0));
					}
					return result;
				};
				const middleware = client.middleware.workspace;
				return middleware && middleware.configuration ? middleware.configuration(params, token, configuration) : configuration(params, token);
			});
		}
		getConfiguration(resource, section) {
			let result = null;
			if (section) {
				const index = section.lastIndexOf(".");
				if (index === -1) result = toJSONObject(vscode_1.workspace.getConfiguration(void 0, resource).get(section));
				else {
					const config = vscode_1.workspace.getConfiguration(section.substr(0, index), resource);
					if (config) result = toJSONObject(config.get(section.substr(index + 1)));
				}
			} else {
				const config = vscode_1.workspace.getConfiguration(void 0, resource);
				result = {};
				for (const key of Object.keys(config)) if (config.has(key)) result[key] = toJSONObject(config.get(key));
			}
			if (result === void 0) result = null;
			return result;
		}
		clear() {}
	};
	exports.ConfigurationFeature = ConfigurationFeature;
	function toJSONObject(obj) {
		if (obj) {
			if (Array.isArray(obj)) return obj.map(toJSONObject);
			else if (typeof obj === "object") {
				const res = Object.create(null);
				for (const key in obj) if (Object.prototype.hasOwnProperty.call(obj, key)) res[key] = toJSONObject(obj[key]);
				return res;
			}
		}
		return obj;
	}
	var SyncConfigurationFeature = class {
		_client;
		isCleared;
		_listeners;
		constructor(_client) {
			this._client = _client;
			this.isCleared = false;
			this._listeners = /* @__PURE__ */ new Map();
		}
		getState() {
			return {
				kind: "workspace",
				id: this.registrationType.method,
				registrations: this._listeners.size > 0
			};
		}
		get registrationType() {
			return vscode_languageserver_protocol_1.DidChangeConfigurationNotification.type;
		}
		fillClientCapabilities(capabilities) {
			(0, features_1.ensure)((0, features_1.ensure)(capabilities, "workspace"), "didChangeConfiguration").dynamicRegistration = true;
		}
		initialize() {
			this.isCleared = false;
			const section = this._client.clientOptions.synchronize?.configurationSection;
			if (section !== void 0) this.register({
				id: (0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID(),
				registerOptions: { section }
			});
		}
		register(data) {
			const disposable = vscode_1.workspace.onDidChangeConfiguration((event) => {
				this.onDidChangeConfiguration(data.registerOptions.section, event);
			});
			this._listeners.set(data.id, disposable);
			if (data.registerOptions.section !== void 0) this.onDidChangeConfiguration(data.registerOptions.section, void 0);
		}
		unregister(id) {
			const disposable = this._listeners.get(id);
			if (disposable) {
				this._listeners.delete(id);
				disposable.dispose();
			}
		}
		clear() {
			for (const disposable of this._listeners.values()) disposable.dispose();
			this._listeners.clear();
			this.isCleared = true;
		}
		onDidChangeConfiguration(configurationSection, event) {
			if (this.isCleared) return;
			let sections;
			if (Is.string(configurationSection)) sections = [configurationSection];
			else sections = configurationSection;
			if (sections !== void 0 && event !== void 0) {
				if (!sections.some((section) => event.affectsConfiguration(section))) return;
			}
			const didChangeConfiguration = async (sections) => {
				if (sections === void 0) return this._client.sendNotification(vscode_languageserver_protocol_1.DidChangeConfigurationNotification.type, { settings: null });
				else return this._client.sendNotification(vscode_languageserver_protocol_1.DidChangeConfigurationNotification.type, { settings: this.extractSettingsInformation(sections) });
			};
			const middleware = this._client.middleware.workspace?.didChangeConfiguration;
			(middleware ? middleware(sections, didChangeConfiguration) : didChangeConfiguration(sections)).catch((error) => {
				this._client.error(`Sending notification ${vscode_languageserver_protocol_1.DidChangeConfigurationNotification.type.method} failed`, error);
			});
		}
		extractSettingsInformation(keys) {
			function ensurePath(config, path) {
				let current = config;
				for (let i = 0; i < path.length - 1; i++) {
					let obj = current[path[i]];
					if (!obj) {
						obj = Object.create(null);
						current[path[i]] = obj;
					}
					current = obj;
				}
				return current;
			}
			const resource = this._client.clientOptions.workspaceFolder ? this._client.clientOptions.workspaceFolder.uri : void 0;
			const result = Object.create(null);
			for (let i = 0; i < keys.length; i++) {
				const key = keys[i];
				const index = key.indexOf(".");
				let config = null;
				if (index >= 0) config = vscode_1.workspace.getConfiguration(key.substr(0, index), resource).get(key.substr(index + 1));
				else config = vscode_1.workspace.getConfiguration(void 0, resource).get(key);
				if (config) {
					const path = keys[i].split(".");
					ensurePath(result, path)[path[path.length - 1]] = toJSONObject(config);
				}
			}
			return result;
		}
	};
	exports.SyncConfigurationFeature = SyncConfigurationFeature;
}));
// node_modules/vscode-languageserver-textdocument/lib/esm/main.js
var main_exports = /* @__PURE__ */ __exportAll({ TextDocument: () => TextDocument });
function mergeSort(data, compare) {
	if (data.length <= 1) return data;
	const p = data.length / 2 | 0;
	const left = data.slice(0, p);
	const right = data.slice(p);
	mergeSort(left, compare);
	mergeSort(right, compare);
	let leftIdx = 0;
	let rightIdx = 0;
	let i = 0;
	while (leftIdx < left.length && rightIdx < right.length) if (compare(left[leftIdx], right[rightIdx]) <= 0) data[i++] = left[leftIdx++];
	else data[i++] = right[rightIdx++];
	while (leftIdx < left.length) data[i++] = left[leftIdx++];
	while (rightIdx < right.length) data[i++] = right[rightIdx++];
	return data;
}
function computeLineOffsets(text, isAtLineStart, textOffset = 0) {
	const result = isAtLineStart ? [textOffset] : [];
	for (let i = 0; i < text.length; i++) {
		const ch = text.charCodeAt(i);
		if (isEOL(ch)) {
			if (ch === 13 && i + 1 < text.length && text.charCodeAt(i + 1) === 10) i++;
			result.push(textOffset + i + 1);
		}
	}
	return result;
}
function isEOL(char) {
	return char === 13 || char === 10;
}
function getWellformedRange(range) {
	const start = range.start;
	const end = range.end;
	if (start.line > end.line || start.line === end.line && start.character > end.character) return {
		start: end,
		end: start
	};
	return range;
}
function getWellformedEdit(textEdit) {
	const range = getWellformedRange(textEdit.range);
	if (range !== textEdit.range) return {
		newText: textEdit.newText,
		range
	};
	return textEdit;
}
var FullTextDocument, TextDocument;
var init_main = __esmMin((() => {
	FullTextDocument = class FullTextDocument {
		constructor(uri, languageId, version, content) {
			this._uri = uri;
			this._languageId = languageId;
			this._version = version;
			this._content = content;
			this._lineOffsets = void 0;
		}
		get uri() {
			return this._uri;
		}
		get languageId() {
			return this._languageId;
		}
		get version() {
			return this._version;
		}
		getText(range) {
			if (range) {
				const start = this.offsetAt(range.start);
				const end = this.offsetAt(range.end);
				return this._content.substring(start, end);
			}
			return this._content;
		}
		update(changes, version) {
			for (const change of changes) if (FullTextDocument.isIncremental(change)) {
				const range = getWellformedRange(change.range);
				const startOffset = this.offsetAt(range.start);
				const endOffset = this.offsetAt(range.end);
				this._content = this._content.substring(0, startOffset) + change.text + this._content.substring(endOffset, this._content.length);
				const insertedEndOffset = startOffset + change.text.length;
				const crlfAtStart = this._content.charCodeAt(startOffset - 1) === 13 && this._content.charCodeAt(startOffset) === 10;
				const crlfAtEnd = this._content.charCodeAt(insertedEndOffset - 1) === 13 && this._content.charCodeAt(insertedEndOffset) === 10;
				if (crlfAtStart || crlfAtEnd) {
					this._lineOffsets = void 0;
					continue;
				}
				const startLine = Math.max(range.start.line, 0);
				const endLine = Math.max(range.end.line, 0);
				let lineOffsets = this._lineOffsets;
				const addedLineOffsets = computeLineOffsets(change.text, false, startOffset);
				if (endLine - startLine === addedLineOffsets.length) for (let i = 0, len = addedLineOffsets.length; i < len; i++) lineOffsets[i + startLine + 1] = addedLineOffsets[i];
				else if (addedLineOffsets.length < 1e4) lineOffsets.splice(startLine + 1, endLine - startLine, ...addedLineOffsets);
				else this._lineOffsets = lineOffsets = lineOffsets.slice(0, startLine + 1).concat(addedLineOffsets, lineOffsets.slice(endLine + 1));
				const diff = change.text.length - (endOffset - startOffset);
				if (diff !== 0) for (let i = startLine + 1 + addedLineOffsets.length, len = lineOffsets.length; i < len; i++) lineOffsets[i] = lineOffsets[i] + diff;
			} else if (FullTextDocument.isFull(change)) {
				this._content = change.text;
				this._lineOffsets = void 0;
			} else throw new Error("Unknown change event received");
			this._version = version;
		}
		getLineOffsets() {
			if (this._lineOffsets === void 0) this._lineOffsets = computeLineOffsets(this._content, true);
			return this._lineOffsets;
		}
		positionAt(offset) {
			offset = Math.max(Math.min(offset, this._content.length), 0);
			const lineOffsets = this.getLineOffsets();
			let low = 0, high = lineOffsets.length;
			if (high === 0) return {
				line: 0,
				character: offset
			};
			while (low < high) {
				const mid = Math.floor((low + high) / 2);
				if (lineOffsets[mid] > offset) high = mid;
				else low = mid + 1;
			}
			const line = low - 1;
			offset = this.ensureBeforeEOL(offset, lineOffsets[line]);
			return {
				line,
				character: offset - lineOffsets[line]
			};
		}
		offsetAt(position) {
			const lineOffsets = this.getLineOffsets();
			if (position.line >= lineOffsets.length) return this._content.length;
			else if (position.line < 0) return 0;
			const lineOffset = lineOffsets[position.line];
			if (position.character <= 0) return lineOffset;
			const nextLineOffset = position.line + 1 < lineOffsets.length ? lineOffsets[position.line + 1] : this._content.length;
			const offset = Math.min(lineOffset + position.character, nextLineOffset);
			return this.ensureBeforeEOL(offset, lineOffset);
		}
		getLineRange(line) {
			const lineOffsets = this.getLineOffsets();
			if (line >= lineOffsets.length) {
				const lastLine = lineOffsets.length - 1;
				return {
					start: {
						line: lastLine,
						character: 0
					},
					end: {
						line: lastLine,
						character: this._content.length - lineOffsets[lastLine]
					}
				};
			} else if (line < 0) return {
				start: {
					line: 0,
					character: 0
				},
				end: {
					line: 0,
					character: 0
				}
			};
			const startOffset = lineOffsets[line];
			const nextLineOffset = line + 1 < lineOffsets.length ? lineOffsets[line + 1] : this._content.length;
			const endOffset = this.ensureBeforeEOL(nextLineOffset, startOffset);
			return {
				start: {
					line,
					character: 0
				},
				end: {
					line,
					character: endOffset - startOffset
				}
			};
		}
		getEOLCharacters(line) {
			const lineOffsets = this.getLineOffsets();
			if (line >= lineOffsets.length) return "";
			else if (line < 0) return "";
			const nextLineOffset = line + 1 < lineOffsets.length ? lineOffsets[line + 1] : this._content.length;
			const eolOffset = this.ensureBeforeEOL(nextLineOffset, lineOffsets[line]);
			return this._content.substring(eolOffset, nextLineOffset);
		}
		ensureBeforeEOL(offset, lineOffset) {
			while (offset > lineOffset && isEOL(this._content.charCodeAt(offset - 1))) offset--;
			return offset;
		}
		get lineCount() {
			return this.getLineOffsets().length;
		}
		static isIncremental(event) {
			const candidate = event;
			return candidate !== void 0 && candidate !== null && typeof candidate.text === "string" && candidate.range !== void 0 && (candidate.rangeLength === void 0 || typeof candidate.rangeLength === "number");
		}
		static isFull(event) {
			const candidate = event;
			return candidate !== void 0 && candidate !== null && typeof candidate.text === "string" && candidate.range === void 0 && candidate.rangeLength === void 0;
		}
	};
	(function(TextDocument) {
		/**
		* Creates a new text document.
		*
		* @param uri The document's uri.
		* @param languageId  The document's language Id.
		* @param version The document's initial version number.
		* @param content The document's content.
		*/
		function create(uri, languageId, version, content) {
			return new FullTextDocument(uri, languageId, version, content);
		}
		TextDocument.create = create;
		/**
		* Updates a TextDocument by modifying its content.
		*
		* @param document the document to update. Only documents created by TextDocument.create are valid inputs.
		* @param changes the changes to apply to the document.
		* @param version the changes version for the document.
		* @returns The updated TextDocument. Note: That's the same document instance passed in as first parameter.
		*
		*/
		function update(document, changes, version) {
			if (document instanceof FullTextDocument) {
				document.update(changes, version);
				return document;
			} else throw new Error("TextDocument.update: document must be created by TextDocument.create");
		}
		TextDocument.update = update;
		function applyEdits(document, edits) {
			const text = document.getText();
			const sortedEdits = mergeSort(edits.map(getWellformedEdit), (a, b) => {
				const diff = a.range.start.line - b.range.start.line;
				if (diff === 0) return a.range.start.character - b.range.start.character;
				return diff;
			});
			let lastModifiedOffset = 0;
			const spans = [];
			for (const e of sortedEdits) {
				const startOffset = document.offsetAt(e.range.start);
				if (startOffset < lastModifiedOffset) throw new Error("Overlapping edit");
				else if (startOffset > lastModifiedOffset) spans.push(text.substring(lastModifiedOffset, startOffset));
				if (e.newText.length) spans.push(e.newText);
				lastModifiedOffset = document.offsetAt(e.range.end);
			}
			spans.push(text.substr(lastModifiedOffset));
			return spans.join("");
		}
		TextDocument.applyEdits = applyEdits;
	})(TextDocument || (TextDocument = {}));
}));
// node_modules/vscode-languageclient/lib/common/textSynchronization.js
var require_textSynchronization = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.DidSaveTextDocumentFeature = exports.WillSaveWaitUntilFeature = exports.WillSaveFeature = exports.DidChangeTextDocumentFeature = exports.DidCloseTextDocumentFeature = exports.DidOpenTextDocumentFeature = void 0;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var features_1 = require_features();
	var vscode_languageserver_textdocument_1 = (init_main(), __toCommonJS(main_exports));
	var DidOpenTextDocumentFeature = class extends features_1.TextDocumentEventFeature {
		_syncedDocuments;
		_pendingOpenNotifications;
		_delayOpen;
		_pendingOpenListeners;
		constructor(client, syncedDocuments) {
			super(client, vscode_1.workspace.onDidOpenTextDocument, vscode_languageserver_protocol_1.DidOpenTextDocumentNotification.type, () => client.middleware.didOpen, (textDocument) => client.code2ProtocolConverter.asOpenTextDocumentParams(textDocument), (data) => data, features_1.TextDocumentEventFeature.textDocumentFilter);
			this._syncedDocuments = syncedDocuments;
			this._pendingOpenNotifications = /* @__PURE__ */ new Map();
			this._delayOpen = client.clientOptions.textSynchronization?.delayOpenNotifications ?? false;
		}
		async callback(document) {
			if (!this._delayOpen) return super.callback(document);
			else {
				if (!this.matches(document)) return;
				if (this._client.visibleDocuments.isVisible(document)) return super.callback(document);
				else {
					const snapshot = new TextDocumentSnapshot(document);
					this._pendingOpenNotifications.set(snapshot.uri.toString(), snapshot);
				}
			}
		}
		get openDocuments() {
			return this._syncedDocuments.values();
		}
		fillClientCapabilities(capabilities) {
			(0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "synchronization").dynamicRegistration = true;
		}
		initialize(capabilities, documentSelector) {
			const textDocumentSyncOptions = capabilities.resolvedTextDocumentSync;
			if (documentSelector && textDocumentSyncOptions && textDocumentSyncOptions.openClose) this.register({
				id: (0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID(),
				registerOptions: { documentSelector }
			});
		}
		get registrationType() {
			return vscode_languageserver_protocol_1.DidOpenTextDocumentNotification.type;
		}
		register(data) {
			super.register(data);
			if (!data.registerOptions.documentSelector) return;
			const documentSelector = this._client.protocol2CodeConverter.asDocumentSelector(data.registerOptions.documentSelector);
			vscode_1.workspace.textDocuments.forEach((textDocument) => {
				const uri = textDocument.uri.toString();
				if (this._syncedDocuments.has(uri)) return;
				if (vscode_1.languages.match(documentSelector, textDocument) > 0 && !this._client.hasDedicatedTextSynchronizationFeature(textDocument)) {
					const visibleDocuments = this._client.visibleDocuments;
					if (!this._delayOpen || visibleDocuments.isVisible(textDocument)) {
						const middleware = this._client.middleware;
						const didOpen = (textDocument) => {
							return this._client.sendNotification(this._type, this._createParams(textDocument));
						};
						(middleware.didOpen ? middleware.didOpen(textDocument, didOpen) : didOpen(textDocument)).catch((error) => {
							this._client.error(`Sending document notification ${this._type.method} failed`, error);
						});
						this._syncedDocuments.set(uri, textDocument);
					} else this._pendingOpenNotifications.set(uri, textDocument);
				}
			});
			if (this._delayOpen && this._pendingOpenListeners === void 0) {
				this._pendingOpenListeners = [];
				const visibleDocuments = this._client.visibleDocuments;
				this._pendingOpenListeners.push(visibleDocuments.onClose((closed) => {
					for (const uri of closed) this._pendingOpenNotifications.delete(uri.toString());
				}));
				this._pendingOpenListeners.push(visibleDocuments.onOpen((opened) => {
					for (const uri of opened) {
						const document = this._pendingOpenNotifications.get(uri.toString());
						if (document !== void 0) {
							super.callback(document).catch(((error) => {
								this._client.error(`Sending document notification ${this._type.method} failed`, error);
							}));
							this._pendingOpenNotifications.delete(uri.toString());
						}
					}
				}));
				this._pendingOpenListeners.push(vscode_1.workspace.onDidCloseTextDocument((document) => {
					this._pendingOpenNotifications.delete(document.uri.toString());
				}));
			}
		}
		/**
		* Sends any pending open notifications.
		*/
		async sendPendingOpenNotifications() {
			const notifications = Array.from(this._pendingOpenNotifications.values());
			this._pendingOpenNotifications.clear();
			for (const notification of notifications) await super.callback(notification);
		}
		/**
		* Drops the pending open notification of a document that is being closed.
		*
		* @param uri The URI of the document being closed.
		* @returns Whether a pending open notification was dropped.
		*/
		dropPendingOpenNotification(uri) {
			return this._pendingOpenNotifications.delete(uri);
		}
		getTextDocument(data) {
			return data;
		}
		notificationSent(textDocument, type, params) {
			this._syncedDocuments.set(textDocument.uri.toString(), textDocument);
			super.notificationSent(textDocument, type, params);
		}
		clear() {
			this._pendingOpenNotifications.clear();
			if (this._pendingOpenListeners !== void 0) {
				for (const listener of this._pendingOpenListeners) listener.dispose();
				this._pendingOpenListeners = void 0;
			}
			super.clear();
		}
	};
	exports.DidOpenTextDocumentFeature = DidOpenTextDocumentFeature;
	var DidCloseTextDocumentFeature = class extends features_1.TextDocumentEventFeature {
		_syncedDocuments;
		_pendingTextDocumentChanges;
		constructor(client, syncedDocuments, pendingTextDocumentChanges) {
			super(client, vscode_1.workspace.onDidCloseTextDocument, vscode_languageserver_protocol_1.DidCloseTextDocumentNotification.type, () => client.middleware.didClose, (textDocument) => client.code2ProtocolConverter.asCloseTextDocumentParams(textDocument), (data) => data, features_1.TextDocumentEventFeature.textDocumentFilter);
			this._syncedDocuments = syncedDocuments;
			this._pendingTextDocumentChanges = pendingTextDocumentChanges;
		}
		get registrationType() {
			return vscode_languageserver_protocol_1.DidCloseTextDocumentNotification.type;
		}
		fillClientCapabilities(capabilities) {
			(0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "synchronization").dynamicRegistration = true;
		}
		initialize(capabilities, documentSelector) {
			const textDocumentSyncOptions = capabilities.resolvedTextDocumentSync;
			if (documentSelector && textDocumentSyncOptions && textDocumentSyncOptions.openClose) this.register({
				id: (0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID(),
				registerOptions: { documentSelector }
			});
		}
		async callback(data) {
			await super.callback(data);
			this._pendingTextDocumentChanges.delete(data.uri.toString());
		}
		getTextDocument(data) {
			return data;
		}
		notificationSent(textDocument, type, params) {
			this._syncedDocuments.delete(textDocument.uri.toString());
			super.notificationSent(textDocument, type, params);
		}
		unregister(id) {
			const selector = this._selectors.get(id);
			if (selector === void 0) return;
			super.unregister(id);
			const selectors = this._selectors.values();
			this._syncedDocuments.forEach((textDocument) => {
				if (vscode_1.languages.match(selector, textDocument) > 0 && !this._selectorFilter(selectors, textDocument) && !this._client.hasDedicatedTextSynchronizationFeature(textDocument)) {
					const middleware = this._client.middleware;
					const didClose = (textDocument) => {
						return this._client.sendNotification(this._type, this._createParams(textDocument));
					};
					this._syncedDocuments.delete(textDocument.uri.toString());
					(middleware.didClose ? middleware.didClose(textDocument, didClose) : didClose(textDocument)).catch((error) => {
						this._client.error(`Sending document notification ${this._type.method} failed`, error);
					});
				}
			});
		}
	};
	exports.DidCloseTextDocumentFeature = DidCloseTextDocumentFeature;
	var DidChangeTextDocumentFeature = class extends features_1.DynamicDocumentFeature {
		_listener;
		_changeData;
		_onAboutToSendNotification;
		_onNotificationSent;
		_onPendingChangeAdded;
		_pendingTextDocumentChanges;
		_syncKind;
		constructor(client, pendingTextDocumentChanges) {
			super(client);
			this._changeData = /* @__PURE__ */ new Map();
			this._onAboutToSendNotification = new vscode_1.EventEmitter();
			this._onNotificationSent = new vscode_1.EventEmitter();
			this._onPendingChangeAdded = new vscode_1.EventEmitter();
			this._pendingTextDocumentChanges = pendingTextDocumentChanges;
			this._syncKind = vscode_languageserver_protocol_1.TextDocumentSyncKind.None;
		}
		get onAboutToSendNotification() {
			return this._onAboutToSendNotification.event;
		}
		get onNotificationSent() {
			return this._onNotificationSent.event;
		}
		get onPendingChangeAdded() {
			return this._onPendingChangeAdded.event;
		}
		get syncKind() {
			return this._syncKind;
		}
		get registrationType() {
			return vscode_languageserver_protocol_1.DidChangeTextDocumentNotification.type;
		}
		fillClientCapabilities(capabilities) {
			(0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "synchronization").dynamicRegistration = true;
		}
		initialize(capabilities, documentSelector) {
			const textDocumentSyncOptions = capabilities.resolvedTextDocumentSync;
			if (documentSelector && textDocumentSyncOptions && textDocumentSyncOptions.change !== void 0 && textDocumentSyncOptions.change !== vscode_languageserver_protocol_1.TextDocumentSyncKind.None) this.register({
				id: (0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID(),
				registerOptions: Object.assign({}, { documentSelector }, { syncKind: textDocumentSyncOptions.change })
			});
		}
		register(data) {
			if (!data.registerOptions.documentSelector) return;
			if (!this._listener) this._listener = vscode_1.workspace.onDidChangeTextDocument(this.callback, this);
			this._changeData.set(data.id, {
				syncKind: data.registerOptions.syncKind,
				documentSelector: this._client.protocol2CodeConverter.asDocumentSelector(data.registerOptions.documentSelector)
			});
			this.updateSyncKind(data.registerOptions.syncKind);
		}
		*getDocumentSelectors() {
			for (const data of this._changeData.values()) yield data.documentSelector;
		}
		async callback(event) {
			if (event.contentChanges.length === 0) return;
			const uri = event.document.uri;
			const version = event.document.version;
			const promises = [];
			for (const changeData of this._changeData.values()) if (vscode_1.languages.match(changeData.documentSelector, event.document) > 0 && !this._client.hasDedicatedTextSynchronizationFeature(event.document)) {
				const middleware = this._client.middleware;
				if (changeData.syncKind === vscode_languageserver_protocol_1.TextDocumentSyncKind.Incremental) {
					const didChange = async (event) => {
						const params = this._client.code2ProtocolConverter.asChangeTextDocumentParams(event, uri, version);
						this.aboutToSendNotification(event.document, vscode_languageserver_protocol_1.DidChangeTextDocumentNotification.type, params);
						await this._client.sendNotification(vscode_languageserver_protocol_1.DidChangeTextDocumentNotification.type, params);
						this.notificationSent(event.document, vscode_languageserver_protocol_1.DidChangeTextDocumentNotification.type, params);
					};
					promises.push(middleware.didChange ? middleware.didChange(event, (event) => didChange(event)) : didChange(event));
				} else if (changeData.syncKind === vscode_languageserver_protocol_1.TextDocumentSyncKind.Full) {
					const didChange = async (event) => {
						const eventUri = event.document.uri.toString();
						this._pendingTextDocumentChanges.set(eventUri, event.document);
						this._onPendingChangeAdded.fire();
					};
					promises.push(middleware.didChange ? middleware.didChange(event, (event) => didChange(event)) : didChange(event));
				}
			}
			return Promise.all(promises).then(void 0, (error) => {
				this._client.error(`Sending document notification ${vscode_languageserver_protocol_1.DidChangeTextDocumentNotification.type.method} failed`, error);
				throw error;
			});
		}
		aboutToSendNotification(textDocument, type, params) {
			this._onAboutToSendNotification.fire({
				textDocument,
				type,
				params
			});
		}
		notificationSent(textDocument, type, params) {
			this._onNotificationSent.fire({
				textDocument,
				type,
				params
			});
		}
		unregister(id) {
			this._changeData.delete(id);
			if (this._changeData.size === 0) {
				if (this._listener) {
					this._listener.dispose();
					this._listener = void 0;
				}
				this._syncKind = vscode_languageserver_protocol_1.TextDocumentSyncKind.None;
			} else {
				this._syncKind = vscode_languageserver_protocol_1.TextDocumentSyncKind.None;
				for (const changeData of this._changeData.values()) {
					this.updateSyncKind(changeData.syncKind);
					if (this._syncKind === vscode_languageserver_protocol_1.TextDocumentSyncKind.Full) break;
				}
			}
		}
		clear() {
			this._pendingTextDocumentChanges.clear();
			this._changeData.clear();
			this._syncKind = vscode_languageserver_protocol_1.TextDocumentSyncKind.None;
			if (this._listener) {
				this._listener.dispose();
				this._listener = void 0;
			}
		}
		getPendingDocumentChanges(excludes) {
			if (this._pendingTextDocumentChanges.size === 0) return [];
			let result;
			if (excludes.size === 0) {
				result = Array.from(this._pendingTextDocumentChanges.values());
				this._pendingTextDocumentChanges.clear();
			} else {
				result = [];
				for (const entry of this._pendingTextDocumentChanges) if (!excludes.has(entry[0])) {
					result.push(entry[1]);
					this._pendingTextDocumentChanges.delete(entry[0]);
				}
			}
			return result;
		}
		getProvider(document) {
			for (const changeData of this._changeData.values()) if (vscode_1.languages.match(changeData.documentSelector, document) > 0) return { send: (event) => {
				return this.callback(event);
			} };
		}
		updateSyncKind(syncKind) {
			if (this._syncKind === vscode_languageserver_protocol_1.TextDocumentSyncKind.Full) return;
			switch (syncKind) {
				case vscode_languageserver_protocol_1.TextDocumentSyncKind.Full:
					this._syncKind = syncKind;
					break;
				case vscode_languageserver_protocol_1.TextDocumentSyncKind.Incremental: if (this._syncKind === vscode_languageserver_protocol_1.TextDocumentSyncKind.None) this._syncKind = vscode_languageserver_protocol_1.TextDocumentSyncKind.Incremental;
			}
		}
	};
	exports.DidChangeTextDocumentFeature = DidChangeTextDocumentFeature;
	var WillSaveFeature = class extends features_1.TextDocumentEventFeature {
		constructor(client) {
			super(client, vscode_1.workspace.onWillSaveTextDocument, vscode_languageserver_protocol_1.WillSaveTextDocumentNotification.type, () => client.middleware.willSave, (willSaveEvent) => client.code2ProtocolConverter.asWillSaveTextDocumentParams(willSaveEvent), (event) => event.document, (selectors, willSaveEvent) => features_1.TextDocumentEventFeature.textDocumentFilter(selectors, willSaveEvent.document));
		}
		get registrationType() {
			return vscode_languageserver_protocol_1.WillSaveTextDocumentNotification.type;
		}
		fillClientCapabilities(capabilities) {
			const value = (0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "synchronization");
			value.willSave = true;
		}
		initialize(capabilities, documentSelector) {
			const textDocumentSyncOptions = capabilities.resolvedTextDocumentSync;
			if (documentSelector && textDocumentSyncOptions && textDocumentSyncOptions.willSave) this.register({
				id: (0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID(),
				registerOptions: { documentSelector }
			});
		}
		getTextDocument(data) {
			return data.document;
		}
	};
	exports.WillSaveFeature = WillSaveFeature;
	var WillSaveWaitUntilFeature = class extends features_1.DynamicDocumentFeature {
		_listener;
		_selectors;
		constructor(client) {
			super(client);
			this._selectors = /* @__PURE__ */ new Map();
		}
		getDocumentSelectors() {
			return this._selectors.values();
		}
		get registrationType() {
			return vscode_languageserver_protocol_1.WillSaveTextDocumentWaitUntilRequest.type;
		}
		fillClientCapabilities(capabilities) {
			const value = (0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "synchronization");
			value.willSaveWaitUntil = true;
		}
		initialize(capabilities, documentSelector) {
			const textDocumentSyncOptions = capabilities.resolvedTextDocumentSync;
			if (documentSelector && textDocumentSyncOptions && textDocumentSyncOptions.willSaveWaitUntil) this.register({
				id: (0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID(),
				registerOptions: { documentSelector }
			});
		}
		register(data) {
			if (!data.registerOptions.documentSelector) return;
			if (!this._listener) this._listener = vscode_1.workspace.onWillSaveTextDocument(this.callback, this);
			this._selectors.set(data.id, this._client.protocol2CodeConverter.asDocumentSelector(data.registerOptions.documentSelector));
		}
		callback(event) {
			if (features_1.TextDocumentEventFeature.textDocumentFilter(this._selectors.values(), event.document) && !this._client.hasDedicatedTextSynchronizationFeature(event.document)) {
				const middleware = this._client.middleware;
				const willSaveWaitUntil = (event) => {
					return this._client.sendRequest(vscode_languageserver_protocol_1.WillSaveTextDocumentWaitUntilRequest.type, this._client.code2ProtocolConverter.asWillSaveTextDocumentParams(event)).then(async (edits) => {
						const vEdits = await this._client.protocol2CodeConverter.asTextEdits(edits);
						return vEdits === void 0 ? [] : vEdits;
					});
				};
				event.waitUntil(middleware.willSaveWaitUntil ? middleware.willSaveWaitUntil(event, willSaveWaitUntil) : willSaveWaitUntil(event));
			}
		}
		unregister(id) {
			this._selectors.delete(id);
			if (this._selectors.size === 0 && this._listener) {
				this._listener.dispose();
				this._listener = void 0;
			}
		}
		clear() {
			this._selectors.clear();
			if (this._listener) {
				this._listener.dispose();
				this._listener = void 0;
			}
		}
	};
	exports.WillSaveWaitUntilFeature = WillSaveWaitUntilFeature;
	var DidSaveTextDocumentFeature = class extends features_1.TextDocumentEventFeature {
		_includeText;
		constructor(client) {
			super(client, vscode_1.workspace.onDidSaveTextDocument, vscode_languageserver_protocol_1.DidSaveTextDocumentNotification.type, () => client.middleware.didSave, (textDocument) => client.code2ProtocolConverter.asSaveTextDocumentParams(textDocument, this._includeText), (data) => data, features_1.TextDocumentEventFeature.textDocumentFilter);
			this._includeText = false;
		}
		get registrationType() {
			return vscode_languageserver_protocol_1.DidSaveTextDocumentNotification.type;
		}
		fillClientCapabilities(capabilities) {
			(0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "synchronization").didSave = true;
		}
		initialize(capabilities, documentSelector) {
			const textDocumentSyncOptions = capabilities.resolvedTextDocumentSync;
			if (documentSelector && textDocumentSyncOptions && textDocumentSyncOptions.save) {
				const saveOptions = typeof textDocumentSyncOptions.save === "boolean" ? { includeText: false } : { includeText: !!textDocumentSyncOptions.save.includeText };
				this.register({
					id: (0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID(),
					registerOptions: Object.assign({}, { documentSelector }, saveOptions)
				});
			}
		}
		register(data) {
			this._includeText = !!data.registerOptions.includeText;
			super.register(data);
		}
		getTextDocument(data) {
			return data;
		}
	};
	exports.DidSaveTextDocumentFeature = DidSaveTextDocumentFeature;
	var USUAL_WORD_SEPARATORS = "`~!@#$%^&*()-=+[{]}\\|;:'\",.<>/?";
	/**
	* Create a word definition regular expression based on default word separators.
	* Optionally provide allowed separators that should be included in words.
	*
	* The default would look like this:
	* /(-?\d*\.\d\w*)|([^\`\~\!\@\#\$\%\^\&\*\(\)\-\=\+\[\{\]\}\\\|\;\:\'\"\,\.\<\>\/\?\s]+)/g
	*/
	function createWordRegExp(allowInWords = "") {
		let source = "(-?\\d*\\.\\d\\w*)|([^";
		for (const sep of USUAL_WORD_SEPARATORS) {
			if (allowInWords.indexOf(sep) >= 0) continue;
			source += "\\" + sep;
		}
		source += "\\s]+)";
		return new RegExp(source, "g");
	}
	var DEFAULT_WORD_REGEXP = createWordRegExp();
	var TextDocumentSnapshot = class TextDocumentSnapshot {
		_extTextDocument;
		_capturedTextDocument;
		_content;
		_uri;
		_fileName;
		_languageId;
		_version;
		_eol;
		_isUntitled;
		_encoding;
		_isDirty;
		_isClosed;
		constructor(textDocument) {
			this._extTextDocument = textDocument;
			this._content = textDocument.getText();
			this._uri = textDocument.uri;
			this._fileName = textDocument.fileName;
			this._languageId = textDocument.languageId;
			this._version = textDocument.version;
			this._eol = textDocument.eol;
			this._isUntitled = textDocument.isUntitled;
			this._encoding = textDocument.encoding;
			this._isDirty = textDocument.isDirty;
			this._isClosed = textDocument.isClosed;
			this._capturedTextDocument = vscode_languageserver_textdocument_1.TextDocument.create(this._uri.toString(), this._languageId, this._version, this._content);
		}
		get uri() {
			return this._uri;
		}
		get languageId() {
			return this._languageId;
		}
		get version() {
			return this._version;
		}
		get eol() {
			return this._eol;
		}
		get isUntitled() {
			return this._isUntitled;
		}
		get encoding() {
			return this._encoding;
		}
		get fileName() {
			return this._fileName;
		}
		get isDirty() {
			return this._isDirty;
		}
		get isClosed() {
			return this._isClosed;
		}
		save() {
			return this.version === this._extTextDocument.version ? this._extTextDocument.save() : Promise.resolve(false);
		}
		get lineCount() {
			return this._capturedTextDocument.lineCount;
		}
		offsetAt(position) {
			return this._capturedTextDocument.offsetAt(position);
		}
		positionAt(offset) {
			const position = this._capturedTextDocument.positionAt(offset);
			return new vscode_1.Position(position.line, position.character);
		}
		getText(range) {
			return this._capturedTextDocument.getText(range);
		}
		lineAt(lineOrPosition) {
			const line = typeof lineOrPosition === "number" ? lineOrPosition : this.validatePosition(lineOrPosition).line;
			if (line < 0 || line >= this.lineCount) throw new RangeError(`Illegal value for line: ${line}`);
			const lineRange = this._capturedTextDocument.getLineRange(line);
			const text = this._capturedTextDocument.getText(lineRange);
			const firstNonWhitespaceCharacterIndex = text.search(/\S/);
			const range = new vscode_1.Range(lineRange.start.line, lineRange.start.character, lineRange.end.line, lineRange.end.character);
			return {
				lineNumber: line,
				text,
				range,
				rangeIncludingLineBreak: line + 1 < this.lineCount ? new vscode_1.Range(range.start.line, range.start.character, line + 1, 0) : range,
				firstNonWhitespaceCharacterIndex: firstNonWhitespaceCharacterIndex === -1 ? text.length : firstNonWhitespaceCharacterIndex,
				isEmptyOrWhitespace: firstNonWhitespaceCharacterIndex === -1
			};
		}
		getWordRangeAtPosition(position, regex) {
			const lineNumber = this.validatePosition(position).line;
			const lineText = this.lineAt(lineNumber).text;
			const wordRegex = TextDocumentSnapshot.getWordRegExp(regex);
			let match;
			wordRegex.lastIndex = 0;
			while ((match = wordRegex.exec(lineText)) !== null) if (match.index <= position.character && wordRegex.lastIndex >= position.character) return new vscode_1.Range(lineNumber, match.index, lineNumber, wordRegex.lastIndex);
		}
		validateRange(range) {
			const start = this.validatePosition(range.start);
			const end = this.validatePosition(range.end);
			if (start === range.start && end === range.end) return range;
			return new vscode_1.Range(start.line, start.character, end.line, end.character);
		}
		validatePosition(position) {
			const line = Math.min(Math.max(position.line, 0), this.lineCount - 1);
			const lineRange = this._capturedTextDocument.getLineRange(line);
			const character = Math.min(Math.max(position.character, 0), lineRange.end.character);
			if (line === position.line && character === position.character) return position;
			return new vscode_1.Position(line, character);
		}
		static getWordRegExp(regex) {
			const result = regex ?? DEFAULT_WORD_REGEXP;
			if (result.flags.includes("g")) return result;
			const flags = `${result.flags}g`;
			return new RegExp(result.source, flags);
		}
	};
}));
// node_modules/vscode-languageclient/lib/common/completion.js
var require_completion = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.CompletionItemFeature = void 0;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var features_1 = require_features();
	var SupportedCompletionItemKinds = [
		vscode_languageserver_protocol_1.CompletionItemKind.Text,
		vscode_languageserver_protocol_1.CompletionItemKind.Method,
		vscode_languageserver_protocol_1.CompletionItemKind.Function,
		vscode_languageserver_protocol_1.CompletionItemKind.Constructor,
		vscode_languageserver_protocol_1.CompletionItemKind.Field,
		vscode_languageserver_protocol_1.CompletionItemKind.Variable,
		vscode_languageserver_protocol_1.CompletionItemKind.Class,
		vscode_languageserver_protocol_1.CompletionItemKind.Interface,
		vscode_languageserver_protocol_1.CompletionItemKind.Module,
		vscode_languageserver_protocol_1.CompletionItemKind.Property,
		vscode_languageserver_protocol_1.CompletionItemKind.Unit,
		vscode_languageserver_protocol_1.CompletionItemKind.Value,
		vscode_languageserver_protocol_1.CompletionItemKind.Enum,
		vscode_languageserver_protocol_1.CompletionItemKind.Keyword,
		vscode_languageserver_protocol_1.CompletionItemKind.Snippet,
		vscode_languageserver_protocol_1.CompletionItemKind.Color,
		vscode_languageserver_protocol_1.CompletionItemKind.File,
		vscode_languageserver_protocol_1.CompletionItemKind.Reference,
		vscode_languageserver_protocol_1.CompletionItemKind.Folder,
		vscode_languageserver_protocol_1.CompletionItemKind.EnumMember,
		vscode_languageserver_protocol_1.CompletionItemKind.Constant,
		vscode_languageserver_protocol_1.CompletionItemKind.Struct,
		vscode_languageserver_protocol_1.CompletionItemKind.Event,
		vscode_languageserver_protocol_1.CompletionItemKind.Operator,
		vscode_languageserver_protocol_1.CompletionItemKind.TypeParameter
	];
	var CompletionItemFeature = class extends features_1.TextDocumentLanguageFeature {
		labelDetailsSupport;
		constructor(client) {
			super(client, vscode_languageserver_protocol_1.CompletionRequest.type);
			this.labelDetailsSupport = /* @__PURE__ */ new Map();
		}
		fillClientCapabilities(capabilities) {
			const completion = (0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "completion");
			completion.dynamicRegistration = true;
			completion.contextSupport = true;
			completion.completionItem = {
				snippetSupport: true,
				commitCharactersSupport: true,
				documentationFormat: [vscode_languageserver_protocol_1.MarkupKind.Markdown, vscode_languageserver_protocol_1.MarkupKind.PlainText],
				deprecatedSupport: true,
				preselectSupport: true,
				tagSupport: { valueSet: [vscode_languageserver_protocol_1.CompletionItemTag.Deprecated] },
				insertReplaceSupport: true,
				resolveSupport: { properties: [
					"documentation",
					"detail",
					"additionalTextEdits"
				] },
				insertTextModeSupport: { valueSet: [vscode_languageserver_protocol_1.InsertTextMode.asIs, vscode_languageserver_protocol_1.InsertTextMode.adjustIndentation] },
				labelDetailsSupport: true
			};
			completion.insertTextMode = vscode_languageserver_protocol_1.InsertTextMode.adjustIndentation;
			completion.completionItemKind = { valueSet: SupportedCompletionItemKinds };
			completion.completionList = {
				itemDefaults: [
					"commitCharacters",
					"editRange",
					"insertTextFormat",
					"insertTextMode",
					"data"
				],
				applyKindSupport: true
			};
		}
		initialize(capabilities, documentSelector) {
			const options = this.getRegistrationOptions(documentSelector, capabilities.completionProvider);
			if (!options) return;
			this.register({
				id: (0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID(),
				registerOptions: options
			});
		}
		registerLanguageProvider(options, id) {
			this.labelDetailsSupport.set(id, !!options.completionItem?.labelDetailsSupport);
			const triggerCharacters = options.triggerCharacters ?? [];
			const defaultCommitCharacters = options.allCommitCharacters;
			const selector = options.documentSelector;
			const provider = {
				provideCompletionItems: (document, position, token, context) => {
					const client = this._client;
					const middleware = this._client.middleware;
					const provideCompletionItems = (document, position, context, token) => {
						return client.sendRequest(vscode_languageserver_protocol_1.CompletionRequest.type, client.code2ProtocolConverter.asCompletionParams(document, position, context), token).then((result) => {
							if (token.isCancellationRequested) return null;
							return client.protocol2CodeConverter.asCompletionResult(result, defaultCommitCharacters, token);
						}, (error) => {
							return client.handleFailedRequest(vscode_languageserver_protocol_1.CompletionRequest.type, token, error, null);
						});
					};
					return middleware.provideCompletionItem ? middleware.provideCompletionItem(document, position, context, token, provideCompletionItems) : provideCompletionItems(document, position, context, token);
				},
				resolveCompletionItem: options.resolveProvider ? (item, token) => {
					const client = this._client;
					const middleware = this._client.middleware;
					const resolveCompletionItem = (item, token) => {
						return client.sendRequest(vscode_languageserver_protocol_1.CompletionResolveRequest.type, client.code2ProtocolConverter.asCompletionItem(item, !!this.labelDetailsSupport.get(id)), token).then((result) => {
							if (token.isCancellationRequested) return null;
							return client.protocol2CodeConverter.asCompletionItem(result);
						}, (error) => {
							return client.handleFailedRequest(vscode_languageserver_protocol_1.CompletionResolveRequest.type, token, error, item);
						});
					};
					return middleware.resolveCompletionItem ? middleware.resolveCompletionItem(item, token, resolveCompletionItem) : resolveCompletionItem(item, token);
				} : void 0
			};
			return [vscode_1.languages.registerCompletionItemProvider(this._client.protocol2CodeConverter.asDocumentSelector(selector), provider, ...triggerCharacters), provider];
		}
	};
	exports.CompletionItemFeature = CompletionItemFeature;
}));
// node_modules/vscode-languageclient/lib/common/hover.js
var require_hover = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.HoverFeature = void 0;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var features_1 = require_features();
	var HoverFeature = class extends features_1.TextDocumentLanguageFeature {
		constructor(client) {
			super(client, vscode_languageserver_protocol_1.HoverRequest.type);
		}
		fillClientCapabilities(capabilities) {
			const hoverCapability = (0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "hover");
			hoverCapability.dynamicRegistration = true;
			hoverCapability.contentFormat = [vscode_languageserver_protocol_1.MarkupKind.Markdown, vscode_languageserver_protocol_1.MarkupKind.PlainText];
		}
		initialize(capabilities, documentSelector) {
			const options = this.getRegistrationOptions(documentSelector, capabilities.hoverProvider);
			if (!options) return;
			this.register({
				id: (0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID(),
				registerOptions: options
			});
		}
		registerLanguageProvider(options) {
			const selector = options.documentSelector;
			const provider = { provideHover: (document, position, token) => {
				const client = this._client;
				const provideHover = (document, position, token) => {
					return client.sendRequest(vscode_languageserver_protocol_1.HoverRequest.type, client.code2ProtocolConverter.asTextDocumentPositionParams(document, position), token).then((result) => {
						if (token.isCancellationRequested) return null;
						return client.protocol2CodeConverter.asHover(result);
					}, (error) => {
						return client.handleFailedRequest(vscode_languageserver_protocol_1.HoverRequest.type, token, error, null);
					});
				};
				const middleware = client.middleware;
				return middleware.provideHover ? middleware.provideHover(document, position, token, provideHover) : provideHover(document, position, token);
			} };
			return [this.registerProvider(selector, provider), provider];
		}
		registerProvider(selector, provider) {
			return vscode_1.languages.registerHoverProvider(this._client.protocol2CodeConverter.asDocumentSelector(selector), provider);
		}
	};
	exports.HoverFeature = HoverFeature;
}));
// node_modules/vscode-languageclient/lib/common/definition.js
var require_definition = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.DefinitionFeature = void 0;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var features_1 = require_features();
	var DefinitionFeature = class extends features_1.TextDocumentLanguageFeature {
		constructor(client) {
			super(client, vscode_languageserver_protocol_1.DefinitionRequest.type);
		}
		fillClientCapabilities(capabilities) {
			const definitionSupport = (0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "definition");
			definitionSupport.dynamicRegistration = true;
			definitionSupport.linkSupport = true;
		}
		initialize(capabilities, documentSelector) {
			const options = this.getRegistrationOptions(documentSelector, capabilities.definitionProvider);
			if (!options) return;
			this.register({
				id: (0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID(),
				registerOptions: options
			});
		}
		registerLanguageProvider(options) {
			const selector = options.documentSelector;
			const provider = { provideDefinition: (document, position, token) => {
				const client = this._client;
				const provideDefinition = (document, position, token) => {
					return client.sendRequest(vscode_languageserver_protocol_1.DefinitionRequest.type, client.code2ProtocolConverter.asTextDocumentPositionParams(document, position), token).then((result) => {
						if (token.isCancellationRequested) return null;
						return client.protocol2CodeConverter.asDefinitionResult(result, token);
					}, (error) => {
						return client.handleFailedRequest(vscode_languageserver_protocol_1.DefinitionRequest.type, token, error, null);
					});
				};
				const middleware = client.middleware;
				return middleware.provideDefinition ? middleware.provideDefinition(document, position, token, provideDefinition) : provideDefinition(document, position, token);
			} };
			return [this.registerProvider(selector, provider), provider];
		}
		registerProvider(selector, provider) {
			return vscode_1.languages.registerDefinitionProvider(this._client.protocol2CodeConverter.asDocumentSelector(selector), provider);
		}
	};
	exports.DefinitionFeature = DefinitionFeature;
}));
// node_modules/vscode-languageclient/lib/common/signatureHelp.js
var require_signatureHelp = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.SignatureHelpFeature = void 0;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var features_1 = require_features();
	var SignatureHelpFeature = class extends features_1.TextDocumentLanguageFeature {
		constructor(client) {
			super(client, vscode_languageserver_protocol_1.SignatureHelpRequest.type);
		}
		fillClientCapabilities(capabilities) {
			const config = (0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "signatureHelp");
			config.dynamicRegistration = true;
			config.signatureInformation = { documentationFormat: [vscode_languageserver_protocol_1.MarkupKind.Markdown, vscode_languageserver_protocol_1.MarkupKind.PlainText] };
			config.signatureInformation.parameterInformation = { labelOffsetSupport: true };
			config.signatureInformation.activeParameterSupport = true;
			config.signatureInformation.noActiveParameterSupport = true;
			config.contextSupport = true;
		}
		initialize(capabilities, documentSelector) {
			const options = this.getRegistrationOptions(documentSelector, capabilities.signatureHelpProvider);
			if (!options) return;
			this.register({
				id: (0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID(),
				registerOptions: options
			});
		}
		registerLanguageProvider(options) {
			const provider = { provideSignatureHelp: (document, position, token, context) => {
				const client = this._client;
				const providerSignatureHelp = (document, position, context, token) => {
					return client.sendRequest(vscode_languageserver_protocol_1.SignatureHelpRequest.type, client.code2ProtocolConverter.asSignatureHelpParams(document, position, context), token).then((result) => {
						if (token.isCancellationRequested) return null;
						return client.protocol2CodeConverter.asSignatureHelp(result, token);
					}, (error) => {
						return client.handleFailedRequest(vscode_languageserver_protocol_1.SignatureHelpRequest.type, token, error, null);
					});
				};
				const middleware = client.middleware;
				return middleware.provideSignatureHelp ? middleware.provideSignatureHelp(document, position, context, token, providerSignatureHelp) : providerSignatureHelp(document, position, context, token);
			} };
			return [this.registerProvider(options, provider), provider];
		}
		registerProvider(options, provider) {
			const selector = this._client.protocol2CodeConverter.asDocumentSelector(options.documentSelector);
			if (options.retriggerCharacters === void 0) {
				const triggerCharacters = options.triggerCharacters || [];
				return vscode_1.languages.registerSignatureHelpProvider(selector, provider, ...triggerCharacters);
			} else {
				const metaData = {
					triggerCharacters: options.triggerCharacters || [],
					retriggerCharacters: options.retriggerCharacters || []
				};
				return vscode_1.languages.registerSignatureHelpProvider(selector, provider, metaData);
			}
		}
	};
	exports.SignatureHelpFeature = SignatureHelpFeature;
}));
// node_modules/vscode-languageclient/lib/common/documentHighlight.js
var require_documentHighlight = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.DocumentHighlightFeature = void 0;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var features_1 = require_features();
	var DocumentHighlightFeature = class extends features_1.TextDocumentLanguageFeature {
		constructor(client) {
			super(client, vscode_languageserver_protocol_1.DocumentHighlightRequest.type);
		}
		fillClientCapabilities(capabilities) {
			(0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "documentHighlight").dynamicRegistration = true;
		}
		initialize(capabilities, documentSelector) {
			const options = this.getRegistrationOptions(documentSelector, capabilities.documentHighlightProvider);
			if (!options) return;
			this.register({
				id: (0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID(),
				registerOptions: options
			});
		}
		registerLanguageProvider(options) {
			const selector = options.documentSelector;
			const provider = { provideDocumentHighlights: (document, position, token) => {
				const client = this._client;
				const _provideDocumentHighlights = (document, position, token) => {
					return client.sendRequest(vscode_languageserver_protocol_1.DocumentHighlightRequest.type, client.code2ProtocolConverter.asTextDocumentPositionParams(document, position), token).then((result) => {
						if (token.isCancellationRequested) return null;
						return client.protocol2CodeConverter.asDocumentHighlights(result, token);
					}, (error) => {
						return client.handleFailedRequest(vscode_languageserver_protocol_1.DocumentHighlightRequest.type, token, error, null);
					});
				};
				const middleware = client.middleware;
				return middleware.provideDocumentHighlights ? middleware.provideDocumentHighlights(document, position, token, _provideDocumentHighlights) : _provideDocumentHighlights(document, position, token);
			} };
			return [vscode_1.languages.registerDocumentHighlightProvider(this._client.protocol2CodeConverter.asDocumentSelector(selector), provider), provider];
		}
	};
	exports.DocumentHighlightFeature = DocumentHighlightFeature;
}));
// node_modules/vscode-languageclient/lib/common/documentSymbol.js
var require_documentSymbol = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.DocumentSymbolFeature = exports.SupportedSymbolTags = exports.SupportedSymbolKinds = void 0;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var features_1 = require_features();
	exports.SupportedSymbolKinds = [
		vscode_languageserver_protocol_1.SymbolKind.File,
		vscode_languageserver_protocol_1.SymbolKind.Module,
		vscode_languageserver_protocol_1.SymbolKind.Namespace,
		vscode_languageserver_protocol_1.SymbolKind.Package,
		vscode_languageserver_protocol_1.SymbolKind.Class,
		vscode_languageserver_protocol_1.SymbolKind.Method,
		vscode_languageserver_protocol_1.SymbolKind.Property,
		vscode_languageserver_protocol_1.SymbolKind.Field,
		vscode_languageserver_protocol_1.SymbolKind.Constructor,
		vscode_languageserver_protocol_1.SymbolKind.Enum,
		vscode_languageserver_protocol_1.SymbolKind.Interface,
		vscode_languageserver_protocol_1.SymbolKind.Function,
		vscode_languageserver_protocol_1.SymbolKind.Variable,
		vscode_languageserver_protocol_1.SymbolKind.Constant,
		vscode_languageserver_protocol_1.SymbolKind.String,
		vscode_languageserver_protocol_1.SymbolKind.Number,
		vscode_languageserver_protocol_1.SymbolKind.Boolean,
		vscode_languageserver_protocol_1.SymbolKind.Array,
		vscode_languageserver_protocol_1.SymbolKind.Object,
		vscode_languageserver_protocol_1.SymbolKind.Key,
		vscode_languageserver_protocol_1.SymbolKind.Null,
		vscode_languageserver_protocol_1.SymbolKind.EnumMember,
		vscode_languageserver_protocol_1.SymbolKind.Struct,
		vscode_languageserver_protocol_1.SymbolKind.Event,
		vscode_languageserver_protocol_1.SymbolKind.Operator,
		vscode_languageserver_protocol_1.SymbolKind.TypeParameter
	];
	exports.SupportedSymbolTags = [vscode_languageserver_protocol_1.SymbolTag.Deprecated];
	var DocumentSymbolFeature = class extends features_1.TextDocumentLanguageFeature {
		constructor(client) {
			super(client, vscode_languageserver_protocol_1.DocumentSymbolRequest.type);
		}
		fillClientCapabilities(capabilities) {
			const symbolCapabilities = (0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "documentSymbol");
			symbolCapabilities.dynamicRegistration = true;
			symbolCapabilities.symbolKind = { valueSet: exports.SupportedSymbolKinds };
			symbolCapabilities.hierarchicalDocumentSymbolSupport = true;
			symbolCapabilities.tagSupport = { valueSet: exports.SupportedSymbolTags };
			symbolCapabilities.labelSupport = true;
		}
		initialize(capabilities, documentSelector) {
			const options = this.getRegistrationOptions(documentSelector, capabilities.documentSymbolProvider);
			if (!options) return;
			this.register({
				id: (0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID(),
				registerOptions: options
			});
		}
		registerLanguageProvider(options) {
			const selector = options.documentSelector;
			const provider = { provideDocumentSymbols: (document, token) => {
				const client = this._client;
				const _provideDocumentSymbols = async (document, token) => {
					try {
						const data = await client.sendRequest(vscode_languageserver_protocol_1.DocumentSymbolRequest.type, client.code2ProtocolConverter.asDocumentSymbolParams(document), token);
						if (token.isCancellationRequested || data === void 0 || data === null) return null;
						if (data.length === 0) return [];
						else {
							const first = data[0];
							if (vscode_languageserver_protocol_1.DocumentSymbol.is(first)) return await client.protocol2CodeConverter.asDocumentSymbols(data, token);
							else return await client.protocol2CodeConverter.asSymbolInformations(data, token);
						}
					} catch (error) {
						return client.handleFailedRequest(vscode_languageserver_protocol_1.DocumentSymbolRequest.type, token, error, null);
					}
				};
				const middleware = client.middleware;
				return middleware.provideDocumentSymbols ? middleware.provideDocumentSymbols(document, token, _provideDocumentSymbols) : _provideDocumentSymbols(document, token);
			} };
			const metaData = options.label !== void 0 ? { label: options.label } : void 0;
			return [vscode_1.languages.registerDocumentSymbolProvider(this._client.protocol2CodeConverter.asDocumentSelector(selector), provider, metaData), provider];
		}
	};
	exports.DocumentSymbolFeature = DocumentSymbolFeature;
}));
// node_modules/vscode-languageclient/lib/common/workspaceSymbol.js
var require_workspaceSymbol = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.WorkspaceSymbolFeature = void 0;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var features_1 = require_features();
	var documentSymbol_1 = require_documentSymbol();
	var WorkspaceSymbolFeature = class extends features_1.WorkspaceFeature {
		constructor(client) {
			super(client, vscode_languageserver_protocol_1.WorkspaceSymbolRequest.type);
		}
		fillClientCapabilities(capabilities) {
			const symbolCapabilities = (0, features_1.ensure)((0, features_1.ensure)(capabilities, "workspace"), "symbol");
			symbolCapabilities.dynamicRegistration = true;
			symbolCapabilities.symbolKind = { valueSet: documentSymbol_1.SupportedSymbolKinds };
			symbolCapabilities.tagSupport = { valueSet: documentSymbol_1.SupportedSymbolTags };
			symbolCapabilities.resolveSupport = { properties: ["location.range"] };
		}
		initialize(capabilities) {
			if (!capabilities.workspaceSymbolProvider) return;
			this.register({
				id: (0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID(),
				registerOptions: capabilities.workspaceSymbolProvider === true ? { workDoneProgress: false } : capabilities.workspaceSymbolProvider
			});
		}
		registerLanguageProvider(options) {
			const provider = {
				provideWorkspaceSymbols: (query, token) => {
					const client = this._client;
					const provideWorkspaceSymbols = (query, token) => {
						return client.sendRequest(vscode_languageserver_protocol_1.WorkspaceSymbolRequest.type, { query }, token).then((result) => {
							if (token.isCancellationRequested) return null;
							return client.protocol2CodeConverter.asSymbolInformations(result, token);
						}, (error) => {
							return client.handleFailedRequest(vscode_languageserver_protocol_1.WorkspaceSymbolRequest.type, token, error, null);
						});
					};
					const middleware = client.middleware;
					return middleware.provideWorkspaceSymbols ? middleware.provideWorkspaceSymbols(query, token, provideWorkspaceSymbols) : provideWorkspaceSymbols(query, token);
				},
				resolveWorkspaceSymbol: options.resolveProvider === true ? (item, token) => {
					const client = this._client;
					const resolveWorkspaceSymbol = (item, token) => {
						return client.sendRequest(vscode_languageserver_protocol_1.WorkspaceSymbolResolveRequest.type, client.code2ProtocolConverter.asWorkspaceSymbol(item), token).then((result) => {
							if (token.isCancellationRequested) return null;
							return client.protocol2CodeConverter.asSymbolInformation(result);
						}, (error) => {
							return client.handleFailedRequest(vscode_languageserver_protocol_1.WorkspaceSymbolResolveRequest.type, token, error, null);
						});
					};
					const middleware = client.middleware;
					return middleware.resolveWorkspaceSymbol ? middleware.resolveWorkspaceSymbol(item, token, resolveWorkspaceSymbol) : resolveWorkspaceSymbol(item, token);
				} : void 0
			};
			return [vscode_1.languages.registerWorkspaceSymbolProvider(provider), provider];
		}
	};
	exports.WorkspaceSymbolFeature = WorkspaceSymbolFeature;
}));
// node_modules/vscode-languageclient/lib/common/reference.js
var require_reference = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.ReferencesFeature = void 0;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var features_1 = require_features();
	var ReferencesFeature = class extends features_1.TextDocumentLanguageFeature {
		constructor(client) {
			super(client, vscode_languageserver_protocol_1.ReferencesRequest.type);
		}
		fillClientCapabilities(capabilities) {
			(0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "references").dynamicRegistration = true;
		}
		initialize(capabilities, documentSelector) {
			const options = this.getRegistrationOptions(documentSelector, capabilities.referencesProvider);
			if (!options) return;
			this.register({
				id: (0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID(),
				registerOptions: options
			});
		}
		registerLanguageProvider(options) {
			const selector = options.documentSelector;
			const provider = { provideReferences: (document, position, options, token) => {
				const client = this._client;
				const _providerReferences = (document, position, options, token) => {
					return client.sendRequest(vscode_languageserver_protocol_1.ReferencesRequest.type, client.code2ProtocolConverter.asReferenceParams(document, position, options), token).then((result) => {
						if (token.isCancellationRequested) return null;
						return client.protocol2CodeConverter.asReferences(result, token);
					}, (error) => {
						return client.handleFailedRequest(vscode_languageserver_protocol_1.ReferencesRequest.type, token, error, null);
					});
				};
				const middleware = client.middleware;
				return middleware.provideReferences ? middleware.provideReferences(document, position, options, token, _providerReferences) : _providerReferences(document, position, options, token);
			} };
			return [this.registerProvider(selector, provider), provider];
		}
		registerProvider(selector, provider) {
			return vscode_1.languages.registerReferenceProvider(this._client.protocol2CodeConverter.asDocumentSelector(selector), provider);
		}
	};
	exports.ReferencesFeature = ReferencesFeature;
}));
// node_modules/vscode-languageclient/lib/common/typeDefinition.js
var require_typeDefinition = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.TypeDefinitionFeature = void 0;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var features_1 = require_features();
	var TypeDefinitionFeature = class extends features_1.TextDocumentLanguageFeature {
		constructor(client) {
			super(client, vscode_languageserver_protocol_1.TypeDefinitionRequest.type);
		}
		fillClientCapabilities(capabilities) {
			(0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "typeDefinition").dynamicRegistration = true;
			const typeDefinitionSupport = (0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "typeDefinition");
			typeDefinitionSupport.dynamicRegistration = true;
			typeDefinitionSupport.linkSupport = true;
		}
		initialize(capabilities, documentSelector) {
			const [id, options] = this.getRegistration(documentSelector, capabilities.typeDefinitionProvider);
			if (!id || !options) return;
			this.register({
				id,
				registerOptions: options
			});
		}
		registerLanguageProvider(options) {
			const selector = options.documentSelector;
			const provider = { provideTypeDefinition: (document, position, token) => {
				const client = this._client;
				const provideTypeDefinition = (document, position, token) => {
					return client.sendRequest(vscode_languageserver_protocol_1.TypeDefinitionRequest.type, client.code2ProtocolConverter.asTextDocumentPositionParams(document, position), token).then((result) => {
						if (token.isCancellationRequested) return null;
						return client.protocol2CodeConverter.asDefinitionResult(result, token);
					}, (error) => {
						return client.handleFailedRequest(vscode_languageserver_protocol_1.TypeDefinitionRequest.type, token, error, null);
					});
				};
				const middleware = client.middleware;
				return middleware.provideTypeDefinition ? middleware.provideTypeDefinition(document, position, token, provideTypeDefinition) : provideTypeDefinition(document, position, token);
			} };
			return [this.registerProvider(selector, provider), provider];
		}
		registerProvider(selector, provider) {
			return vscode_1.languages.registerTypeDefinitionProvider(this._client.protocol2CodeConverter.asDocumentSelector(selector), provider);
		}
	};
	exports.TypeDefinitionFeature = TypeDefinitionFeature;
}));
// node_modules/vscode-languageclient/lib/common/implementation.js
var require_implementation = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.ImplementationFeature = void 0;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var features_1 = require_features();
	var ImplementationFeature = class extends features_1.TextDocumentLanguageFeature {
		constructor(client) {
			super(client, vscode_languageserver_protocol_1.ImplementationRequest.type);
		}
		fillClientCapabilities(capabilities) {
			const implementationSupport = (0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "implementation");
			implementationSupport.dynamicRegistration = true;
			implementationSupport.linkSupport = true;
		}
		initialize(capabilities, documentSelector) {
			const [id, options] = this.getRegistration(documentSelector, capabilities.implementationProvider);
			if (!id || !options) return;
			this.register({
				id,
				registerOptions: options
			});
		}
		registerLanguageProvider(options) {
			const selector = options.documentSelector;
			const provider = { provideImplementation: (document, position, token) => {
				const client = this._client;
				const provideImplementation = (document, position, token) => {
					return client.sendRequest(vscode_languageserver_protocol_1.ImplementationRequest.type, client.code2ProtocolConverter.asTextDocumentPositionParams(document, position), token).then((result) => {
						if (token.isCancellationRequested) return null;
						return client.protocol2CodeConverter.asDefinitionResult(result, token);
					}, (error) => {
						return client.handleFailedRequest(vscode_languageserver_protocol_1.ImplementationRequest.type, token, error, null);
					});
				};
				const middleware = client.middleware;
				return middleware.provideImplementation ? middleware.provideImplementation(document, position, token, provideImplementation) : provideImplementation(document, position, token);
			} };
			return [this.registerProvider(selector, provider), provider];
		}
		registerProvider(selector, provider) {
			return vscode_1.languages.registerImplementationProvider(this._client.protocol2CodeConverter.asDocumentSelector(selector), provider);
		}
	};
	exports.ImplementationFeature = ImplementationFeature;
}));
// node_modules/vscode-languageclient/lib/common/colorProvider.js
var require_colorProvider = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.ColorProviderFeature = void 0;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var features_1 = require_features();
	var ColorProviderFeature = class extends features_1.TextDocumentLanguageFeature {
		constructor(client) {
			super(client, vscode_languageserver_protocol_1.DocumentColorRequest.type);
		}
		fillClientCapabilities(capabilities) {
			(0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "colorProvider").dynamicRegistration = true;
		}
		initialize(capabilities, documentSelector) {
			const [id, options] = this.getRegistration(documentSelector, capabilities.colorProvider);
			if (!id || !options) return;
			this.register({
				id,
				registerOptions: options
			});
		}
		registerLanguageProvider(options) {
			const selector = options.documentSelector;
			const provider = {
				provideColorPresentations: (color, context, token) => {
					const client = this._client;
					const provideColorPresentations = (color, context, token) => {
						const requestParams = {
							color,
							textDocument: client.code2ProtocolConverter.asTextDocumentIdentifier(context.document),
							range: client.code2ProtocolConverter.asRange(context.range)
						};
						return client.sendRequest(vscode_languageserver_protocol_1.ColorPresentationRequest.type, requestParams, token).then((result) => {
							if (token.isCancellationRequested) return null;
							return this._client.protocol2CodeConverter.asColorPresentations(result, token);
						}, (error) => {
							return client.handleFailedRequest(vscode_languageserver_protocol_1.ColorPresentationRequest.type, token, error, null);
						});
					};
					const middleware = client.middleware;
					return middleware.provideColorPresentations ? middleware.provideColorPresentations(color, context, token, provideColorPresentations) : provideColorPresentations(color, context, token);
				},
				provideDocumentColors: (document, token) => {
					const client = this._client;
					const provideDocumentColors = (document, token) => {
						const requestParams = { textDocument: client.code2ProtocolConverter.asTextDocumentIdentifier(document) };
						return client.sendRequest(vscode_languageserver_protocol_1.DocumentColorRequest.type, requestParams, token).then((result) => {
							if (token.isCancellationRequested) return null;
							return this._client.protocol2CodeConverter.asColorInformations(result, token);
						}, (error) => {
							return client.handleFailedRequest(vscode_languageserver_protocol_1.DocumentColorRequest.type, token, error, null);
						});
					};
					const middleware = client.middleware;
					return middleware.provideDocumentColors ? middleware.provideDocumentColors(document, token, provideDocumentColors) : provideDocumentColors(document, token);
				}
			};
			return [vscode_1.languages.registerColorProvider(this._client.protocol2CodeConverter.asDocumentSelector(selector), provider), provider];
		}
	};
	exports.ColorProviderFeature = ColorProviderFeature;
}));
// node_modules/vscode-languageclient/lib/common/codeAction.js
var require_codeAction = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.CodeActionFeature = void 0;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var features_1 = require_features();
	var CodeActionFeature = class extends features_1.TextDocumentLanguageFeature {
		constructor(client) {
			super(client, vscode_languageserver_protocol_1.CodeActionRequest.type);
		}
		fillClientCapabilities(capabilities) {
			const cap = (0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "codeAction");
			cap.dynamicRegistration = true;
			cap.isPreferredSupport = true;
			cap.disabledSupport = true;
			cap.dataSupport = true;
			cap.resolveSupport = { properties: ["edit", "command"] };
			cap.codeActionLiteralSupport = { codeActionKind: { valueSet: [
				vscode_languageserver_protocol_1.CodeActionKind.Empty,
				vscode_languageserver_protocol_1.CodeActionKind.QuickFix,
				vscode_languageserver_protocol_1.CodeActionKind.Refactor,
				vscode_languageserver_protocol_1.CodeActionKind.RefactorExtract,
				vscode_languageserver_protocol_1.CodeActionKind.RefactorInline,
				vscode_languageserver_protocol_1.CodeActionKind.RefactorMove,
				vscode_languageserver_protocol_1.CodeActionKind.RefactorRewrite,
				vscode_languageserver_protocol_1.CodeActionKind.Source,
				vscode_languageserver_protocol_1.CodeActionKind.SourceOrganizeImports,
				vscode_languageserver_protocol_1.CodeActionKind.Notebook
			] } };
			cap.honorsChangeAnnotations = true;
			cap.documentationSupport = true;
			cap.tagSupport = { valueSet: [vscode_languageserver_protocol_1.CodeActionTag.LLMGenerated] };
		}
		initialize(capabilities, documentSelector) {
			const options = this.getRegistrationOptions(documentSelector, capabilities.codeActionProvider);
			if (!options) return;
			this.register({
				id: (0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID(),
				registerOptions: options
			});
		}
		registerLanguageProvider(options) {
			const selector = options.documentSelector;
			const provider = {
				provideCodeActions: (document, range, context, token) => {
					const client = this._client;
					const _provideCodeActions = async (document, range, context, token) => {
						const params = {
							textDocument: client.code2ProtocolConverter.asTextDocumentIdentifier(document),
							range: client.code2ProtocolConverter.asRange(range),
							context: client.code2ProtocolConverter.asCodeActionContextSync(context)
						};
						return client.sendRequest(vscode_languageserver_protocol_1.CodeActionRequest.type, params, token).then((values) => {
							if (token.isCancellationRequested || values === null || values === void 0) return null;
							return client.protocol2CodeConverter.asCodeActionResult(values, token);
						}, (error) => {
							return client.handleFailedRequest(vscode_languageserver_protocol_1.CodeActionRequest.type, token, error, null);
						});
					};
					const middleware = client.middleware;
					return middleware.provideCodeActions ? middleware.provideCodeActions(document, range, context, token, _provideCodeActions) : _provideCodeActions(document, range, context, token);
				},
				resolveCodeAction: options.resolveProvider ? (item, token) => {
					const client = this._client;
					const middleware = this._client.middleware;
					const resolveCodeAction = async (item, token) => {
						return client.sendRequest(vscode_languageserver_protocol_1.CodeActionResolveRequest.type, client.code2ProtocolConverter.asCodeActionSync(item), token).then((result) => {
							if (token.isCancellationRequested) return item;
							return client.protocol2CodeConverter.asCodeAction(result, token);
						}, (error) => {
							return client.handleFailedRequest(vscode_languageserver_protocol_1.CodeActionResolveRequest.type, token, error, item);
						});
					};
					return middleware.resolveCodeAction ? middleware.resolveCodeAction(item, token, resolveCodeAction) : resolveCodeAction(item, token);
				} : void 0
			};
			return [vscode_1.languages.registerCodeActionsProvider(this._client.protocol2CodeConverter.asDocumentSelector(selector), provider, this.getMetadata(options)), provider];
		}
		getMetadata(options) {
			if (options.codeActionKinds === void 0 && options.documentation === void 0) return;
			return {
				providedCodeActionKinds: this._client.protocol2CodeConverter.asCodeActionKinds(options.codeActionKinds),
				documentation: this._client.protocol2CodeConverter.asCodeActionDocumentations(options.documentation)
			};
		}
	};
	exports.CodeActionFeature = CodeActionFeature;
}));
// node_modules/vscode-languageclient/lib/common/codeLens.js
var require_codeLens = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.CodeLensFeature = void 0;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var features_1 = require_features();
	var CodeLensFeature = class extends features_1.TextDocumentLanguageFeature {
		constructor(client) {
			super(client, vscode_languageserver_protocol_1.CodeLensRequest.type);
		}
		fillClientCapabilities(capabilities) {
			const clc = (0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "codeLens");
			clc.dynamicRegistration = true;
			clc.resolveSupport = { properties: ["command"] };
			(0, features_1.ensure)((0, features_1.ensure)(capabilities, "workspace"), "codeLens").refreshSupport = true;
		}
		initialize(capabilities, documentSelector) {
			this._client.onRequest(vscode_languageserver_protocol_1.CodeLensRefreshRequest.type, async () => {
				for (const provider of this.getAllProviders()) provider.onDidChangeCodeLensEmitter.fire();
			});
			const options = this.getRegistrationOptions(documentSelector, capabilities.codeLensProvider);
			if (!options) return;
			this.register({
				id: (0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID(),
				registerOptions: options
			});
		}
		registerLanguageProvider(options) {
			const selector = options.documentSelector;
			const eventEmitter = new vscode_1.EventEmitter();
			const provider = {
				onDidChangeCodeLenses: eventEmitter.event,
				provideCodeLenses: (document, token) => {
					const client = this._client;
					const provideCodeLenses = (document, token) => {
						return client.sendRequest(vscode_languageserver_protocol_1.CodeLensRequest.type, client.code2ProtocolConverter.asCodeLensParams(document), token).then((result) => {
							if (token.isCancellationRequested) return null;
							return client.protocol2CodeConverter.asCodeLenses(result, token);
						}, (error) => {
							return client.handleFailedRequest(vscode_languageserver_protocol_1.CodeLensRequest.type, token, error, null);
						});
					};
					const middleware = client.middleware;
					return middleware.provideCodeLenses ? middleware.provideCodeLenses(document, token, provideCodeLenses) : provideCodeLenses(document, token);
				},
				resolveCodeLens: options.resolveProvider ? (codeLens, token) => {
					const client = this._client;
					const resolveCodeLens = (codeLens, token) => {
						return client.sendRequest(vscode_languageserver_protocol_1.CodeLensResolveRequest.type, client.code2ProtocolConverter.asCodeLens(codeLens), token).then((result) => {
							if (token.isCancellationRequested) return codeLens;
							return client.protocol2CodeConverter.asCodeLens(result);
						}, (error) => {
							return client.handleFailedRequest(vscode_languageserver_protocol_1.CodeLensResolveRequest.type, token, error, codeLens);
						});
					};
					const middleware = client.middleware;
					return middleware.resolveCodeLens ? middleware.resolveCodeLens(codeLens, token, resolveCodeLens) : resolveCodeLens(codeLens, token);
				} : void 0
			};
			return [vscode_1.languages.registerCodeLensProvider(this._client.protocol2CodeConverter.asDocumentSelector(selector), provider), {
				provider,
				onDidChangeCodeLensEmitter: eventEmitter
			}];
		}
	};
	exports.CodeLensFeature = CodeLensFeature;
}));
// node_modules/vscode-languageclient/lib/common/formatting.js
var require_formatting = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.DocumentOnTypeFormattingFeature = exports.DocumentRangeFormattingFeature = exports.DocumentFormattingFeature = void 0;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var features_1 = require_features();
	var FileFormattingOptions;
	(function(FileFormattingOptions) {
		function fromConfiguration(document) {
			const filesConfig = vscode_1.workspace.getConfiguration("files", document);
			return {
				trimTrailingWhitespace: filesConfig.get("trimTrailingWhitespace"),
				trimFinalNewlines: filesConfig.get("trimFinalNewlines"),
				insertFinalNewline: filesConfig.get("insertFinalNewline")
			};
		}
		FileFormattingOptions.fromConfiguration = fromConfiguration;
	})(FileFormattingOptions || (FileFormattingOptions = {}));
	var DocumentFormattingFeature = class extends features_1.TextDocumentLanguageFeature {
		constructor(client) {
			super(client, vscode_languageserver_protocol_1.DocumentFormattingRequest.type);
		}
		fillClientCapabilities(capabilities) {
			(0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "formatting").dynamicRegistration = true;
		}
		initialize(capabilities, documentSelector) {
			const options = this.getRegistrationOptions(documentSelector, capabilities.documentFormattingProvider);
			if (!options) return;
			this.register({
				id: (0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID(),
				registerOptions: options
			});
		}
		registerLanguageProvider(options) {
			const selector = options.documentSelector;
			const provider = { provideDocumentFormattingEdits: (document, options, token) => {
				const client = this._client;
				const provideDocumentFormattingEdits = (document, options, token) => {
					const params = {
						textDocument: client.code2ProtocolConverter.asTextDocumentIdentifier(document),
						options: client.code2ProtocolConverter.asFormattingOptions(options, FileFormattingOptions.fromConfiguration(document))
					};
					return client.sendRequest(vscode_languageserver_protocol_1.DocumentFormattingRequest.type, params, token).then((result) => {
						if (token.isCancellationRequested) return null;
						return client.protocol2CodeConverter.asTextEdits(result, token);
					}, (error) => {
						return client.handleFailedRequest(vscode_languageserver_protocol_1.DocumentFormattingRequest.type, token, error, null);
					});
				};
				const middleware = client.middleware;
				return middleware.provideDocumentFormattingEdits ? middleware.provideDocumentFormattingEdits(document, options, token, provideDocumentFormattingEdits) : provideDocumentFormattingEdits(document, options, token);
			} };
			return [vscode_1.languages.registerDocumentFormattingEditProvider(this._client.protocol2CodeConverter.asDocumentSelector(selector), provider), provider];
		}
	};
	exports.DocumentFormattingFeature = DocumentFormattingFeature;
	var DocumentRangeFormattingFeature = class extends features_1.TextDocumentLanguageFeature {
		constructor(client) {
			super(client, vscode_languageserver_protocol_1.DocumentRangeFormattingRequest.type);
		}
		fillClientCapabilities(capabilities) {
			const capability = (0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "rangeFormatting");
			capability.dynamicRegistration = true;
			capability.rangesSupport = true;
		}
		initialize(capabilities, documentSelector) {
			const options = this.getRegistrationOptions(documentSelector, capabilities.documentRangeFormattingProvider);
			if (!options) return;
			this.register({
				id: (0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID(),
				registerOptions: options
			});
		}
		registerLanguageProvider(options) {
			const selector = options.documentSelector;
			const provider = { provideDocumentRangeFormattingEdits: (document, range, options, token) => {
				const client = this._client;
				const provideDocumentRangeFormattingEdits = (document, range, options, token) => {
					const params = {
						textDocument: client.code2ProtocolConverter.asTextDocumentIdentifier(document),
						range: client.code2ProtocolConverter.asRange(range),
						options: client.code2ProtocolConverter.asFormattingOptions(options, FileFormattingOptions.fromConfiguration(document))
					};
					return client.sendRequest(vscode_languageserver_protocol_1.DocumentRangeFormattingRequest.type, params, token).then((result) => {
						if (token.isCancellationRequested) return null;
						return client.protocol2CodeConverter.asTextEdits(result, token);
					}, (error) => {
						return client.handleFailedRequest(vscode_languageserver_protocol_1.DocumentRangeFormattingRequest.type, token, error, null);
					});
				};
				const middleware = client.middleware;
				return middleware.provideDocumentRangeFormattingEdits ? middleware.provideDocumentRangeFormattingEdits(document, range, options, token, provideDocumentRangeFormattingEdits) : provideDocumentRangeFormattingEdits(document, range, options, token);
			} };
			if (options.rangesSupport) provider.provideDocumentRangesFormattingEdits = (document, ranges, options, token) => {
				const client = this._client;
				const provideDocumentRangesFormattingEdits = (document, ranges, options, token) => {
					const params = {
						textDocument: client.code2ProtocolConverter.asTextDocumentIdentifier(document),
						ranges: client.code2ProtocolConverter.asRanges(ranges),
						options: client.code2ProtocolConverter.asFormattingOptions(options, FileFormattingOptions.fromConfiguration(document))
					};
					return client.sendRequest(vscode_languageserver_protocol_1.DocumentRangesFormattingRequest.type, params, token).then((result) => {
						if (token.isCancellationRequested) return null;
						return client.protocol2CodeConverter.asTextEdits(result, token);
					}, (error) => {
						return client.handleFailedRequest(vscode_languageserver_protocol_1.DocumentRangesFormattingRequest.type, token, error, null);
					});
				};
				const middleware = client.middleware;
				return middleware.provideDocumentRangesFormattingEdits ? middleware.provideDocumentRangesFormattingEdits(document, ranges, options, token, provideDocumentRangesFormattingEdits) : provideDocumentRangesFormattingEdits(document, ranges, options, token);
			};
			return [vscode_1.languages.registerDocumentRangeFormattingEditProvider(this._client.protocol2CodeConverter.asDocumentSelector(selector), provider), provider];
		}
	};
	exports.DocumentRangeFormattingFeature = DocumentRangeFormattingFeature;
	var DocumentOnTypeFormattingFeature = class extends features_1.TextDocumentLanguageFeature {
		constructor(client) {
			super(client, vscode_languageserver_protocol_1.DocumentOnTypeFormattingRequest.type);
		}
		fillClientCapabilities(capabilities) {
			(0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "onTypeFormatting").dynamicRegistration = true;
		}
		initialize(capabilities, documentSelector) {
			const options = this.getRegistrationOptions(documentSelector, capabilities.documentOnTypeFormattingProvider);
			if (!options) return;
			this.register({
				id: (0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID(),
				registerOptions: options
			});
		}
		registerLanguageProvider(options) {
			const selector = options.documentSelector;
			const provider = { provideOnTypeFormattingEdits: (document, position, ch, options, token) => {
				const client = this._client;
				const provideOnTypeFormattingEdits = (document, position, ch, options, token) => {
					const params = {
						textDocument: client.code2ProtocolConverter.asTextDocumentIdentifier(document),
						position: client.code2ProtocolConverter.asPosition(position),
						ch,
						options: client.code2ProtocolConverter.asFormattingOptions(options, FileFormattingOptions.fromConfiguration(document))
					};
					return client.sendRequest(vscode_languageserver_protocol_1.DocumentOnTypeFormattingRequest.type, params, token).then((result) => {
						if (token.isCancellationRequested) return null;
						return client.protocol2CodeConverter.asTextEdits(result, token);
					}, (error) => {
						return client.handleFailedRequest(vscode_languageserver_protocol_1.DocumentOnTypeFormattingRequest.type, token, error, null);
					});
				};
				const middleware = client.middleware;
				return middleware.provideOnTypeFormattingEdits ? middleware.provideOnTypeFormattingEdits(document, position, ch, options, token, provideOnTypeFormattingEdits) : provideOnTypeFormattingEdits(document, position, ch, options, token);
			} };
			const moreTriggerCharacter = options.moreTriggerCharacter || [];
			return [vscode_1.languages.registerOnTypeFormattingEditProvider(this._client.protocol2CodeConverter.asDocumentSelector(selector), provider, options.firstTriggerCharacter, ...moreTriggerCharacter), provider];
		}
	};
	exports.DocumentOnTypeFormattingFeature = DocumentOnTypeFormattingFeature;
}));
// node_modules/vscode-languageclient/lib/common/rename.js
var require_rename = /* @__PURE__ */ __commonJSMin(((exports, module, this$11) => {
	var __createBinding = this$11 && this$11.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$11 && this$11.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$11 && this$11.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.RenameFeature = void 0;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var Is = __importStar(require_is$2());
	var features_1 = require_features();
	var RenameFeature = class extends features_1.TextDocumentLanguageFeature {
		constructor(client) {
			super(client, vscode_languageserver_protocol_1.RenameRequest.type);
		}
		fillClientCapabilities(capabilities) {
			const rename = (0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "rename");
			rename.dynamicRegistration = true;
			rename.prepareSupport = true;
			rename.prepareSupportDefaultBehavior = vscode_languageserver_protocol_1.PrepareSupportDefaultBehavior.Identifier;
			rename.honorsChangeAnnotations = true;
		}
		initialize(capabilities, documentSelector) {
			const options = this.getRegistrationOptions(documentSelector, capabilities.renameProvider);
			if (!options) return;
			if (Is.boolean(capabilities.renameProvider)) options.prepareProvider = false;
			this.register({
				id: (0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID(),
				registerOptions: options
			});
		}
		registerLanguageProvider(options) {
			const selector = options.documentSelector;
			const provider = {
				provideRenameEdits: (document, position, newName, token) => {
					const client = this._client;
					const provideRenameEdits = async (document, position, newName, token) => {
						const params = {
							textDocument: client.code2ProtocolConverter.asTextDocumentIdentifier(document),
							position: client.code2ProtocolConverter.asPosition(position),
							newName
						};
						let result = null;
						try {
							result = await client.sendRequest(vscode_languageserver_protocol_1.RenameRequest.type, params, token);
						} catch (error) {
							return client.handleFailedRequest(vscode_languageserver_protocol_1.RenameRequest.type, token, error, null, false);
						}
						if (token.isCancellationRequested || result === null) return null;
						const converted = await client.protocol2CodeConverter.asWorkspaceEdit(result, token);
						if (token.isCancellationRequested) return null;
						if (!client.validateWorkspaceEdit(result)) throw new Error(`The rename edit returned from the server is not valid anymore and cannot be applied.`);
						return converted;
					};
					const middleware = client.middleware;
					return middleware.provideRenameEdits ? middleware.provideRenameEdits(document, position, newName, token, provideRenameEdits) : provideRenameEdits(document, position, newName, token);
				},
				prepareRename: options.prepareProvider ? (document, position, token) => {
					const client = this._client;
					const prepareRename = (document, position, token) => {
						const params = {
							textDocument: client.code2ProtocolConverter.asTextDocumentIdentifier(document),
							position: client.code2ProtocolConverter.asPosition(position)
						};
						return client.sendRequest(vscode_languageserver_protocol_1.PrepareRenameRequest.type, params, token).then((result) => {
							if (token.isCancellationRequested) return null;
							if (vscode_languageserver_protocol_1.Range.is(result)) return client.protocol2CodeConverter.asRange(result);
							else if (this.isDefaultBehavior(result)) return result.defaultBehavior === true ? null : Promise.reject(/* @__PURE__ */ new Error(`The element can't be renamed.`));
							else if (result && vscode_languageserver_protocol_1.Range.is(result.range)) return {
								range: client.protocol2CodeConverter.asRange(result.range),
								placeholder: result.placeholder
							};
							return Promise.reject(/* @__PURE__ */ new Error(`The element can't be renamed.`));
						}, (error) => {
							if (typeof error.message === "string") throw new Error(error.message);
							else throw new Error(`The element can't be renamed.`);
						});
					};
					const middleware = client.middleware;
					return middleware.prepareRename ? middleware.prepareRename(document, position, token, prepareRename) : prepareRename(document, position, token);
				} : void 0
			};
			return [this.registerProvider(selector, provider), provider];
		}
		registerProvider(selector, provider) {
			return vscode_1.languages.registerRenameProvider(this._client.protocol2CodeConverter.asDocumentSelector(selector), provider);
		}
		isDefaultBehavior(value) {
			const candidate = value;
			return candidate && Is.boolean(candidate.defaultBehavior);
		}
	};
	exports.RenameFeature = RenameFeature;
}));
// node_modules/vscode-languageclient/lib/common/documentLink.js
var require_documentLink = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.DocumentLinkFeature = void 0;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var features_1 = require_features();
	var DocumentLinkFeature = class extends features_1.TextDocumentLanguageFeature {
		constructor(client) {
			super(client, vscode_languageserver_protocol_1.DocumentLinkRequest.type);
		}
		fillClientCapabilities(capabilities) {
			const documentLinkCapabilities = (0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "documentLink");
			documentLinkCapabilities.dynamicRegistration = true;
			documentLinkCapabilities.tooltipSupport = true;
		}
		initialize(capabilities, documentSelector) {
			const options = this.getRegistrationOptions(documentSelector, capabilities.documentLinkProvider);
			if (!options) return;
			this.register({
				id: (0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID(),
				registerOptions: options
			});
		}
		registerLanguageProvider(options) {
			const selector = options.documentSelector;
			const provider = {
				provideDocumentLinks: (document, token) => {
					const client = this._client;
					const provideDocumentLinks = (document, token) => {
						return client.sendRequest(vscode_languageserver_protocol_1.DocumentLinkRequest.type, client.code2ProtocolConverter.asDocumentLinkParams(document), token).then((result) => {
							if (token.isCancellationRequested) return null;
							return client.protocol2CodeConverter.asDocumentLinks(result, token);
						}, (error) => {
							return client.handleFailedRequest(vscode_languageserver_protocol_1.DocumentLinkRequest.type, token, error, null);
						});
					};
					const middleware = client.middleware;
					return middleware.provideDocumentLinks ? middleware.provideDocumentLinks(document, token, provideDocumentLinks) : provideDocumentLinks(document, token);
				},
				resolveDocumentLink: options.resolveProvider ? (link, token) => {
					const client = this._client;
					const resolveDocumentLink = (link, token) => {
						return client.sendRequest(vscode_languageserver_protocol_1.DocumentLinkResolveRequest.type, client.code2ProtocolConverter.asDocumentLink(link), token).then((result) => {
							if (token.isCancellationRequested) return link;
							return client.protocol2CodeConverter.asDocumentLink(result);
						}, (error) => {
							return client.handleFailedRequest(vscode_languageserver_protocol_1.DocumentLinkResolveRequest.type, token, error, link);
						});
					};
					const middleware = client.middleware;
					return middleware.resolveDocumentLink ? middleware.resolveDocumentLink(link, token, resolveDocumentLink) : resolveDocumentLink(link, token);
				} : void 0
			};
			return [vscode_1.languages.registerDocumentLinkProvider(this._client.protocol2CodeConverter.asDocumentSelector(selector), provider), provider];
		}
	};
	exports.DocumentLinkFeature = DocumentLinkFeature;
}));
// node_modules/vscode-languageclient/lib/common/executeCommand.js
var require_executeCommand = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.ExecuteCommandFeature = void 0;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var features_1 = require_features();
	var ExecuteCommandFeature = class {
		_client;
		_commands;
		constructor(client) {
			this._client = client;
			this._commands = /* @__PURE__ */ new Map();
		}
		getState() {
			return {
				kind: "workspace",
				id: this.registrationType.method,
				registrations: this._commands.size > 0
			};
		}
		get registrationType() {
			return vscode_languageserver_protocol_1.ExecuteCommandRequest.type;
		}
		fillClientCapabilities(capabilities) {
			(0, features_1.ensure)((0, features_1.ensure)(capabilities, "workspace"), "executeCommand").dynamicRegistration = true;
		}
		initialize(capabilities) {
			if (!capabilities.executeCommandProvider) return;
			this.register({
				id: (0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID(),
				registerOptions: Object.assign({}, capabilities.executeCommandProvider)
			});
		}
		register(data) {
			const client = this._client;
			const middleware = client.middleware;
			const executeCommand = (command, args) => {
				const params = {
					command,
					arguments: args
				};
				return client.sendRequest(vscode_languageserver_protocol_1.ExecuteCommandRequest.type, params).then(void 0, (error) => {
					return client.handleFailedRequest(vscode_languageserver_protocol_1.ExecuteCommandRequest.type, void 0, error, void 0);
				});
			};
			if (data.registerOptions.commands) {
				const disposables = [];
				for (const command of data.registerOptions.commands) disposables.push(vscode_1.commands.registerCommand(command, (...args) => {
					return middleware.executeCommand ? middleware.executeCommand(command, args, executeCommand) : executeCommand(command, args);
				}));
				this._commands.set(data.id, disposables);
			}
		}
		unregister(id) {
			const disposables = this._commands.get(id);
			if (disposables) {
				this._commands.delete(id);
				disposables.forEach((disposable) => disposable.dispose());
			}
		}
		clear() {
			this._commands.forEach((value) => {
				value.forEach((disposable) => disposable.dispose());
			});
			this._commands.clear();
		}
	};
	exports.ExecuteCommandFeature = ExecuteCommandFeature;
}));
// node_modules/vscode-languageclient/lib/common/foldingRange.js
var require_foldingRange = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.FoldingRangeFeature = void 0;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var features_1 = require_features();
	var FoldingRangeFeature = class extends features_1.TextDocumentLanguageFeature {
		constructor(client) {
			super(client, vscode_languageserver_protocol_1.FoldingRangeRequest.type);
		}
		fillClientCapabilities(capabilities) {
			const capability = (0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "foldingRange");
			capability.dynamicRegistration = true;
			capability.rangeLimit = 5e3;
			capability.lineFoldingOnly = true;
			capability.foldingRangeKind = { valueSet: [
				vscode_languageserver_protocol_1.FoldingRangeKind.Comment,
				vscode_languageserver_protocol_1.FoldingRangeKind.Imports,
				vscode_languageserver_protocol_1.FoldingRangeKind.Region
			] };
			capability.foldingRange = { collapsedText: false };
			(0, features_1.ensure)((0, features_1.ensure)(capabilities, "workspace"), "foldingRange").refreshSupport = true;
		}
		initialize(capabilities, documentSelector) {
			this._client.onRequest(vscode_languageserver_protocol_1.FoldingRangeRefreshRequest.type, async () => {
				for (const provider of this.getAllProviders()) provider.onDidChangeFoldingRange.fire();
			});
			const [id, options] = this.getRegistration(documentSelector, capabilities.foldingRangeProvider);
			if (!id || !options) return;
			this.register({
				id,
				registerOptions: options
			});
		}
		registerLanguageProvider(options) {
			const selector = options.documentSelector;
			const eventEmitter = new vscode_1.EventEmitter();
			const provider = {
				onDidChangeFoldingRanges: eventEmitter.event,
				provideFoldingRanges: (document, context, token) => {
					const client = this._client;
					const provideFoldingRanges = (document, _, token) => {
						const requestParams = { textDocument: client.code2ProtocolConverter.asTextDocumentIdentifier(document) };
						return client.sendRequest(vscode_languageserver_protocol_1.FoldingRangeRequest.type, requestParams, token).then((result) => {
							if (token.isCancellationRequested) return null;
							return client.protocol2CodeConverter.asFoldingRanges(result, token);
						}, (error) => {
							return client.handleFailedRequest(vscode_languageserver_protocol_1.FoldingRangeRequest.type, token, error, null);
						});
					};
					const middleware = client.middleware;
					return middleware.provideFoldingRanges ? middleware.provideFoldingRanges(document, context, token, provideFoldingRanges) : provideFoldingRanges(document, context, token);
				}
			};
			return [vscode_1.languages.registerFoldingRangeProvider(this._client.protocol2CodeConverter.asDocumentSelector(selector), provider), {
				provider,
				onDidChangeFoldingRange: eventEmitter
			}];
		}
	};
	exports.FoldingRangeFeature = FoldingRangeFeature;
}));
// node_modules/vscode-languageclient/lib/common/declaration.js
var require_declaration = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.DeclarationFeature = void 0;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var features_1 = require_features();
	var DeclarationFeature = class extends features_1.TextDocumentLanguageFeature {
		constructor(client) {
			super(client, vscode_languageserver_protocol_1.DeclarationRequest.type);
		}
		fillClientCapabilities(capabilities) {
			const declarationSupport = (0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "declaration");
			declarationSupport.dynamicRegistration = true;
			declarationSupport.linkSupport = true;
		}
		initialize(capabilities, documentSelector) {
			const [id, options] = this.getRegistration(documentSelector, capabilities.declarationProvider);
			if (!id || !options) return;
			this.register({
				id,
				registerOptions: options
			});
		}
		registerLanguageProvider(options) {
			const selector = options.documentSelector;
			const provider = { provideDeclaration: (document, position, token) => {
				const client = this._client;
				const provideDeclaration = (document, position, token) => {
					return client.sendRequest(vscode_languageserver_protocol_1.DeclarationRequest.type, client.code2ProtocolConverter.asTextDocumentPositionParams(document, position), token).then((result) => {
						if (token.isCancellationRequested) return null;
						return client.protocol2CodeConverter.asDeclarationResult(result, token);
					}, (error) => {
						return client.handleFailedRequest(vscode_languageserver_protocol_1.DeclarationRequest.type, token, error, null);
					});
				};
				const middleware = client.middleware;
				return middleware.provideDeclaration ? middleware.provideDeclaration(document, position, token, provideDeclaration) : provideDeclaration(document, position, token);
			} };
			return [this.registerProvider(selector, provider), provider];
		}
		registerProvider(selector, provider) {
			return vscode_1.languages.registerDeclarationProvider(this._client.protocol2CodeConverter.asDocumentSelector(selector), provider);
		}
	};
	exports.DeclarationFeature = DeclarationFeature;
}));
// node_modules/vscode-languageclient/lib/common/selectionRange.js
var require_selectionRange = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.SelectionRangeFeature = void 0;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var features_1 = require_features();
	var SelectionRangeFeature = class extends features_1.TextDocumentLanguageFeature {
		constructor(client) {
			super(client, vscode_languageserver_protocol_1.SelectionRangeRequest.type);
		}
		fillClientCapabilities(capabilities) {
			const capability = (0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "selectionRange");
			capability.dynamicRegistration = true;
		}
		initialize(capabilities, documentSelector) {
			const [id, options] = this.getRegistration(documentSelector, capabilities.selectionRangeProvider);
			if (!id || !options) return;
			this.register({
				id,
				registerOptions: options
			});
		}
		registerLanguageProvider(options) {
			const selector = options.documentSelector;
			const provider = { provideSelectionRanges: (document, positions, token) => {
				const client = this._client;
				const provideSelectionRanges = async (document, positions, token) => {
					const requestParams = {
						textDocument: client.code2ProtocolConverter.asTextDocumentIdentifier(document),
						positions: client.code2ProtocolConverter.asPositionsSync(positions, token)
					};
					return client.sendRequest(vscode_languageserver_protocol_1.SelectionRangeRequest.type, requestParams, token).then((ranges) => {
						if (token.isCancellationRequested) return null;
						return client.protocol2CodeConverter.asSelectionRanges(ranges, token);
					}, (error) => {
						return client.handleFailedRequest(vscode_languageserver_protocol_1.SelectionRangeRequest.type, token, error, null);
					});
				};
				const middleware = client.middleware;
				return middleware.provideSelectionRanges ? middleware.provideSelectionRanges(document, positions, token, provideSelectionRanges) : provideSelectionRanges(document, positions, token);
			} };
			return [this.registerProvider(selector, provider), provider];
		}
		registerProvider(selector, provider) {
			return vscode_1.languages.registerSelectionRangeProvider(this._client.protocol2CodeConverter.asDocumentSelector(selector), provider);
		}
	};
	exports.SelectionRangeFeature = SelectionRangeFeature;
}));
// node_modules/vscode-languageclient/lib/common/callHierarchy.js
var require_callHierarchy = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.CallHierarchyFeature = void 0;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var features_1 = require_features();
	var CallHierarchyProvider = class {
		client;
		middleware;
		constructor(client) {
			this.client = client;
			this.middleware = client.middleware;
		}
		prepareCallHierarchy(document, position, token) {
			const client = this.client;
			const middleware = this.middleware;
			const prepareCallHierarchy = (document, position, token) => {
				const params = client.code2ProtocolConverter.asTextDocumentPositionParams(document, position);
				return client.sendRequest(vscode_languageserver_protocol_1.CallHierarchyPrepareRequest.type, params, token).then((result) => {
					if (token.isCancellationRequested) return null;
					return client.protocol2CodeConverter.asCallHierarchyItems(result, token);
				}, (error) => {
					return client.handleFailedRequest(vscode_languageserver_protocol_1.CallHierarchyPrepareRequest.type, token, error, null);
				});
			};
			return middleware.prepareCallHierarchy ? middleware.prepareCallHierarchy(document, position, token, prepareCallHierarchy) : prepareCallHierarchy(document, position, token);
		}
		provideCallHierarchyIncomingCalls(item, token) {
			const client = this.client;
			const middleware = this.middleware;
			const provideCallHierarchyIncomingCalls = (item, token) => {
				const params = { item: client.code2ProtocolConverter.asCallHierarchyItem(item) };
				return client.sendRequest(vscode_languageserver_protocol_1.CallHierarchyIncomingCallsRequest.type, params, token).then((result) => {
					if (token.isCancellationRequested) return null;
					return client.protocol2CodeConverter.asCallHierarchyIncomingCalls(result, token);
				}, (error) => {
					return client.handleFailedRequest(vscode_languageserver_protocol_1.CallHierarchyIncomingCallsRequest.type, token, error, null);
				});
			};
			return middleware.provideCallHierarchyIncomingCalls ? middleware.provideCallHierarchyIncomingCalls(item, token, provideCallHierarchyIncomingCalls) : provideCallHierarchyIncomingCalls(item, token);
		}
		provideCallHierarchyOutgoingCalls(item, token) {
			const client = this.client;
			const middleware = this.middleware;
			const provideCallHierarchyOutgoingCalls = (item, token) => {
				const params = { item: client.code2ProtocolConverter.asCallHierarchyItem(item) };
				return client.sendRequest(vscode_languageserver_protocol_1.CallHierarchyOutgoingCallsRequest.type, params, token).then((result) => {
					if (token.isCancellationRequested) return null;
					return client.protocol2CodeConverter.asCallHierarchyOutgoingCalls(result, token);
				}, (error) => {
					return client.handleFailedRequest(vscode_languageserver_protocol_1.CallHierarchyOutgoingCallsRequest.type, token, error, null);
				});
			};
			return middleware.provideCallHierarchyOutgoingCalls ? middleware.provideCallHierarchyOutgoingCalls(item, token, provideCallHierarchyOutgoingCalls) : provideCallHierarchyOutgoingCalls(item, token);
		}
	};
	var CallHierarchyFeature = class extends features_1.TextDocumentLanguageFeature {
		constructor(client) {
			super(client, vscode_languageserver_protocol_1.CallHierarchyPrepareRequest.type);
		}
		fillClientCapabilities(cap) {
			const capabilities = cap;
			const capability = (0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "callHierarchy");
			capability.dynamicRegistration = true;
		}
		initialize(capabilities, documentSelector) {
			const [id, options] = this.getRegistration(documentSelector, capabilities.callHierarchyProvider);
			if (!id || !options) return;
			this.register({
				id,
				registerOptions: options
			});
		}
		registerLanguageProvider(options) {
			const client = this._client;
			const provider = new CallHierarchyProvider(client);
			return [vscode_1.languages.registerCallHierarchyProvider(this._client.protocol2CodeConverter.asDocumentSelector(options.documentSelector), provider), provider];
		}
	};
	exports.CallHierarchyFeature = CallHierarchyFeature;
}));
// node_modules/vscode-languageclient/lib/common/semanticTokens.js
var require_semanticTokens = /* @__PURE__ */ __commonJSMin(((exports, module, this$10) => {
	var __createBinding = this$10 && this$10.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$10 && this$10.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$10 && this$10.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.SemanticTokensFeature = void 0;
	var vscode = __importStar(require("vscode"));
	var vscode_languageserver_protocol_1 = require_api$1();
	var features_1 = require_features();
	var Is = __importStar(require_is$2());
	var SemanticTokensFeature = class extends features_1.TextDocumentLanguageFeature {
		constructor(client) {
			super(client, vscode_languageserver_protocol_1.SemanticTokensRegistrationType.type);
		}
		fillClientCapabilities(capabilities) {
			const capability = (0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "semanticTokens");
			capability.dynamicRegistration = true;
			capability.tokenTypes = [
				vscode_languageserver_protocol_1.SemanticTokenTypes.namespace,
				vscode_languageserver_protocol_1.SemanticTokenTypes.type,
				vscode_languageserver_protocol_1.SemanticTokenTypes.class,
				vscode_languageserver_protocol_1.SemanticTokenTypes.enum,
				vscode_languageserver_protocol_1.SemanticTokenTypes.interface,
				vscode_languageserver_protocol_1.SemanticTokenTypes.struct,
				vscode_languageserver_protocol_1.SemanticTokenTypes.typeParameter,
				vscode_languageserver_protocol_1.SemanticTokenTypes.parameter,
				vscode_languageserver_protocol_1.SemanticTokenTypes.variable,
				vscode_languageserver_protocol_1.SemanticTokenTypes.property,
				vscode_languageserver_protocol_1.SemanticTokenTypes.enumMember,
				vscode_languageserver_protocol_1.SemanticTokenTypes.event,
				vscode_languageserver_protocol_1.SemanticTokenTypes.function,
				vscode_languageserver_protocol_1.SemanticTokenTypes.method,
				vscode_languageserver_protocol_1.SemanticTokenTypes.macro,
				vscode_languageserver_protocol_1.SemanticTokenTypes.keyword,
				vscode_languageserver_protocol_1.SemanticTokenTypes.comment,
				vscode_languageserver_protocol_1.SemanticTokenTypes.string,
				vscode_languageserver_protocol_1.SemanticTokenTypes.number,
				vscode_languageserver_protocol_1.SemanticTokenTypes.regexp,
				vscode_languageserver_protocol_1.SemanticTokenTypes.operator,
				vscode_languageserver_protocol_1.SemanticTokenTypes.decorator,
				vscode_languageserver_protocol_1.SemanticTokenTypes.label
			];
			capability.tokenModifiers = [
				vscode_languageserver_protocol_1.SemanticTokenModifiers.declaration,
				vscode_languageserver_protocol_1.SemanticTokenModifiers.definition,
				vscode_languageserver_protocol_1.SemanticTokenModifiers.readonly,
				vscode_languageserver_protocol_1.SemanticTokenModifiers.static,
				vscode_languageserver_protocol_1.SemanticTokenModifiers.deprecated,
				vscode_languageserver_protocol_1.SemanticTokenModifiers.abstract,
				vscode_languageserver_protocol_1.SemanticTokenModifiers.async,
				vscode_languageserver_protocol_1.SemanticTokenModifiers.modification,
				vscode_languageserver_protocol_1.SemanticTokenModifiers.documentation,
				vscode_languageserver_protocol_1.SemanticTokenModifiers.defaultLibrary
			];
			capability.formats = [vscode_languageserver_protocol_1.TokenFormat.Relative];
			capability.requests = {
				range: true,
				full: { delta: true }
			};
			capability.multilineTokenSupport = false;
			capability.overlappingTokenSupport = false;
			capability.serverCancelSupport = true;
			capability.augmentsSyntaxTokens = true;
			(0, features_1.ensure)((0, features_1.ensure)(capabilities, "workspace"), "semanticTokens").refreshSupport = true;
		}
		initialize(capabilities, documentSelector) {
			this._client.onRequest(vscode_languageserver_protocol_1.SemanticTokensRefreshRequest.type, async () => {
				for (const provider of this.getAllProviders()) provider.onDidChangeSemanticTokensEmitter.fire();
			});
			const [id, options] = this.getRegistration(documentSelector, capabilities.semanticTokensProvider);
			if (!id || !options) return;
			this.register({
				id,
				registerOptions: options
			});
		}
		registerLanguageProvider(options) {
			const selector = options.documentSelector;
			const fullProvider = Is.boolean(options.full) ? options.full : options.full !== void 0;
			const hasEditProvider = options.full !== void 0 && typeof options.full !== "boolean" && options.full.delta === true;
			const eventEmitter = new vscode.EventEmitter();
			const documentProvider = fullProvider ? {
				onDidChangeSemanticTokens: eventEmitter.event,
				provideDocumentSemanticTokens: (document, token) => {
					const client = this._client;
					const middleware = client.middleware;
					const provideDocumentSemanticTokens = (document, token) => {
						const params = { textDocument: client.code2ProtocolConverter.asTextDocumentIdentifier(document) };
						return client.sendRequest(vscode_languageserver_protocol_1.SemanticTokensRequest.type, params, token).then((result) => {
							if (token.isCancellationRequested) return null;
							return client.protocol2CodeConverter.asSemanticTokens(result, token);
						}, (error) => {
							return client.handleFailedRequest(vscode_languageserver_protocol_1.SemanticTokensRequest.type, token, error, null);
						});
					};
					return middleware.provideDocumentSemanticTokens ? middleware.provideDocumentSemanticTokens(document, token, provideDocumentSemanticTokens) : provideDocumentSemanticTokens(document, token);
				},
				provideDocumentSemanticTokensEdits: hasEditProvider ? (document, previousResultId, token) => {
					const client = this._client;
					const middleware = client.middleware;
					const provideDocumentSemanticTokensEdits = (document, previousResultId, token) => {
						const params = {
							textDocument: client.code2ProtocolConverter.asTextDocumentIdentifier(document),
							previousResultId
						};
						return client.sendRequest(vscode_languageserver_protocol_1.SemanticTokensDeltaRequest.type, params, token).then(async (result) => {
							if (token.isCancellationRequested) return null;
							if (vscode_languageserver_protocol_1.SemanticTokens.is(result)) return await client.protocol2CodeConverter.asSemanticTokens(result, token);
							else return await client.protocol2CodeConverter.asSemanticTokensEdits(result, token);
						}, (error) => {
							return client.handleFailedRequest(vscode_languageserver_protocol_1.SemanticTokensDeltaRequest.type, token, error, null);
						});
					};
					return middleware.provideDocumentSemanticTokensEdits ? middleware.provideDocumentSemanticTokensEdits(document, previousResultId, token, provideDocumentSemanticTokensEdits) : provideDocumentSemanticTokensEdits(document, previousResultId, token);
				} : void 0
			} : void 0;
			const rangeProvider = options.range === true ? {
				onDidChangeSemanticTokens: eventEmitter.event,
				provideDocumentRangeSemanticTokens: (document, range, token) => {
					const client = this._client;
					const middleware = client.middleware;
					const provideDocumentRangeSemanticTokens = (document, range, token) => {
						const params = {
							textDocument: client.code2ProtocolConverter.asTextDocumentIdentifier(document),
							range: client.code2ProtocolConverter.asRange(range)
						};
						return client.sendRequest(vscode_languageserver_protocol_1.SemanticTokensRangeRequest.type, params, token).then((result) => {
							if (token.isCancellationRequested) return null;
							return client.protocol2CodeConverter.asSemanticTokens(result, token);
						}, (error) => {
							return client.handleFailedRequest(vscode_languageserver_protocol_1.SemanticTokensRangeRequest.type, token, error, null);
						});
					};
					return middleware.provideDocumentRangeSemanticTokens ? middleware.provideDocumentRangeSemanticTokens(document, range, token, provideDocumentRangeSemanticTokens) : provideDocumentRangeSemanticTokens(document, range, token);
				}
			} : void 0;
			const disposables = [];
			const client = this._client;
			const legend = client.protocol2CodeConverter.asSemanticTokensLegend(options.legend);
			const documentSelector = client.protocol2CodeConverter.asDocumentSelector(selector);
			if (documentProvider !== void 0) disposables.push(vscode.languages.registerDocumentSemanticTokensProvider(documentSelector, documentProvider, legend));
			if (rangeProvider !== void 0) disposables.push(vscode.languages.registerDocumentRangeSemanticTokensProvider(documentSelector, rangeProvider, legend));
			return [new vscode.Disposable(() => disposables.forEach((item) => item.dispose())), {
				range: rangeProvider,
				full: documentProvider,
				onDidChangeSemanticTokensEmitter: eventEmitter
			}];
		}
	};
	exports.SemanticTokensFeature = SemanticTokensFeature;
}));
// node_modules/vscode-languageclient/lib/common/linkedEditingRange.js
var require_linkedEditingRange = /* @__PURE__ */ __commonJSMin(((exports, module, this$9) => {
	var __createBinding = this$9 && this$9.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$9 && this$9.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$9 && this$9.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.LinkedEditingFeature = void 0;
	var code = __importStar(require("vscode"));
	var proto = __importStar(require_api$1());
	var features_1 = require_features();
	var LinkedEditingFeature = class extends features_1.TextDocumentLanguageFeature {
		constructor(client) {
			super(client, proto.LinkedEditingRangeRequest.type);
		}
		fillClientCapabilities(capabilities) {
			const linkedEditingSupport = (0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "linkedEditingRange");
			linkedEditingSupport.dynamicRegistration = true;
		}
		initialize(capabilities, documentSelector) {
			const [id, options] = this.getRegistration(documentSelector, capabilities.linkedEditingRangeProvider);
			if (!id || !options) return;
			this.register({
				id,
				registerOptions: options
			});
		}
		registerLanguageProvider(options) {
			const selector = options.documentSelector;
			const provider = { provideLinkedEditingRanges: (document, position, token) => {
				const client = this._client;
				const provideLinkedEditing = (document, position, token) => {
					return client.sendRequest(proto.LinkedEditingRangeRequest.type, client.code2ProtocolConverter.asTextDocumentPositionParams(document, position), token).then((result) => {
						if (token.isCancellationRequested) return null;
						return client.protocol2CodeConverter.asLinkedEditingRanges(result, token);
					}, (error) => {
						return client.handleFailedRequest(proto.LinkedEditingRangeRequest.type, token, error, null);
					});
				};
				const middleware = client.middleware;
				return middleware.provideLinkedEditingRange ? middleware.provideLinkedEditingRange(document, position, token, provideLinkedEditing) : provideLinkedEditing(document, position, token);
			} };
			return [this.registerProvider(selector, provider), provider];
		}
		registerProvider(selector, provider) {
			return code.languages.registerLinkedEditingRangeProvider(this._client.protocol2CodeConverter.asDocumentSelector(selector), provider);
		}
	};
	exports.LinkedEditingFeature = LinkedEditingFeature;
}));
// node_modules/vscode-languageclient/lib/common/typeHierarchy.js
var require_typeHierarchy = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.TypeHierarchyFeature = void 0;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var features_1 = require_features();
	var TypeHierarchyProvider = class {
		client;
		middleware;
		constructor(client) {
			this.client = client;
			this.middleware = client.middleware;
		}
		prepareTypeHierarchy(document, position, token) {
			const client = this.client;
			const middleware = this.middleware;
			const prepareTypeHierarchy = (document, position, token) => {
				const params = client.code2ProtocolConverter.asTextDocumentPositionParams(document, position);
				return client.sendRequest(vscode_languageserver_protocol_1.TypeHierarchyPrepareRequest.type, params, token).then((result) => {
					if (token.isCancellationRequested) return null;
					return client.protocol2CodeConverter.asTypeHierarchyItems(result, token);
				}, (error) => {
					return client.handleFailedRequest(vscode_languageserver_protocol_1.TypeHierarchyPrepareRequest.type, token, error, null);
				});
			};
			return middleware.prepareTypeHierarchy ? middleware.prepareTypeHierarchy(document, position, token, prepareTypeHierarchy) : prepareTypeHierarchy(document, position, token);
		}
		provideTypeHierarchySupertypes(item, token) {
			const client = this.client;
			const middleware = this.middleware;
			const provideTypeHierarchySupertypes = (item, token) => {
				const params = { item: client.code2ProtocolConverter.asTypeHierarchyItem(item) };
				return client.sendRequest(vscode_languageserver_protocol_1.TypeHierarchySupertypesRequest.type, params, token).then((result) => {
					if (token.isCancellationRequested) return null;
					return client.protocol2CodeConverter.asTypeHierarchyItems(result, token);
				}, (error) => {
					return client.handleFailedRequest(vscode_languageserver_protocol_1.TypeHierarchySupertypesRequest.type, token, error, null);
				});
			};
			return middleware.provideTypeHierarchySupertypes ? middleware.provideTypeHierarchySupertypes(item, token, provideTypeHierarchySupertypes) : provideTypeHierarchySupertypes(item, token);
		}
		provideTypeHierarchySubtypes(item, token) {
			const client = this.client;
			const middleware = this.middleware;
			const provideTypeHierarchySubtypes = (item, token) => {
				const params = { item: client.code2ProtocolConverter.asTypeHierarchyItem(item) };
				return client.sendRequest(vscode_languageserver_protocol_1.TypeHierarchySubtypesRequest.type, params, token).then((result) => {
					if (token.isCancellationRequested) return null;
					return client.protocol2CodeConverter.asTypeHierarchyItems(result, token);
				}, (error) => {
					return client.handleFailedRequest(vscode_languageserver_protocol_1.TypeHierarchySubtypesRequest.type, token, error, null);
				});
			};
			return middleware.provideTypeHierarchySubtypes ? middleware.provideTypeHierarchySubtypes(item, token, provideTypeHierarchySubtypes) : provideTypeHierarchySubtypes(item, token);
		}
	};
	var TypeHierarchyFeature = class extends features_1.TextDocumentLanguageFeature {
		constructor(client) {
			super(client, vscode_languageserver_protocol_1.TypeHierarchyPrepareRequest.type);
		}
		fillClientCapabilities(capabilities) {
			const capability = (0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "typeHierarchy");
			capability.dynamicRegistration = true;
		}
		initialize(capabilities, documentSelector) {
			const [id, options] = this.getRegistration(documentSelector, capabilities.typeHierarchyProvider);
			if (!id || !options) return;
			this.register({
				id,
				registerOptions: options
			});
		}
		registerLanguageProvider(options) {
			const client = this._client;
			const provider = new TypeHierarchyProvider(client);
			return [vscode_1.languages.registerTypeHierarchyProvider(client.protocol2CodeConverter.asDocumentSelector(options.documentSelector), provider), provider];
		}
	};
	exports.TypeHierarchyFeature = TypeHierarchyFeature;
}));
// node_modules/vscode-languageclient/lib/common/inlineValue.js
var require_inlineValue = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.InlineValueFeature = void 0;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var features_1 = require_features();
	var InlineValueFeature = class extends features_1.TextDocumentLanguageFeature {
		constructor(client) {
			super(client, vscode_languageserver_protocol_1.InlineValueRequest.type);
		}
		fillClientCapabilities(capabilities) {
			(0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "inlineValue").dynamicRegistration = true;
			(0, features_1.ensure)((0, features_1.ensure)(capabilities, "workspace"), "inlineValue").refreshSupport = true;
		}
		initialize(capabilities, documentSelector) {
			this._client.onRequest(vscode_languageserver_protocol_1.InlineValueRefreshRequest.type, async () => {
				for (const provider of this.getAllProviders()) provider.onDidChangeInlineValues.fire();
			});
			const [id, options] = this.getRegistration(documentSelector, capabilities.inlineValueProvider);
			if (!id || !options) return;
			this.register({
				id,
				registerOptions: options
			});
		}
		registerLanguageProvider(options) {
			const selector = options.documentSelector;
			const eventEmitter = new vscode_1.EventEmitter();
			const provider = {
				onDidChangeInlineValues: eventEmitter.event,
				provideInlineValues: (document, viewPort, context, token) => {
					const client = this._client;
					const provideInlineValues = (document, viewPort, context, token) => {
						const requestParams = {
							textDocument: client.code2ProtocolConverter.asTextDocumentIdentifier(document),
							range: client.code2ProtocolConverter.asRange(viewPort),
							context: client.code2ProtocolConverter.asInlineValueContext(context)
						};
						return client.sendRequest(vscode_languageserver_protocol_1.InlineValueRequest.type, requestParams, token).then((values) => {
							if (token.isCancellationRequested) return null;
							return client.protocol2CodeConverter.asInlineValues(values, token);
						}, (error) => {
							return client.handleFailedRequest(vscode_languageserver_protocol_1.InlineValueRequest.type, token, error, null);
						});
					};
					const middleware = client.middleware;
					return middleware.provideInlineValues ? middleware.provideInlineValues(document, viewPort, context, token, provideInlineValues) : provideInlineValues(document, viewPort, context, token);
				}
			};
			return [this.registerProvider(selector, provider), {
				provider,
				onDidChangeInlineValues: eventEmitter
			}];
		}
		registerProvider(selector, provider) {
			return vscode_1.languages.registerInlineValuesProvider(this._client.protocol2CodeConverter.asDocumentSelector(selector), provider);
		}
	};
	exports.InlineValueFeature = InlineValueFeature;
}));
// node_modules/vscode-languageclient/lib/common/inlayHint.js
var require_inlayHint = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.InlayHintsFeature = void 0;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var features_1 = require_features();
	var InlayHintsFeature = class extends features_1.TextDocumentLanguageFeature {
		constructor(client) {
			super(client, vscode_languageserver_protocol_1.InlayHintRequest.type);
		}
		fillClientCapabilities(capabilities) {
			const inlayHint = (0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "inlayHint");
			inlayHint.dynamicRegistration = true;
			inlayHint.resolveSupport = { properties: [
				"tooltip",
				"textEdits",
				"label.tooltip",
				"label.location",
				"label.command"
			] };
			(0, features_1.ensure)((0, features_1.ensure)(capabilities, "workspace"), "inlayHint").refreshSupport = true;
		}
		initialize(capabilities, documentSelector) {
			this._client.onRequest(vscode_languageserver_protocol_1.InlayHintRefreshRequest.type, async () => {
				for (const provider of this.getAllProviders()) provider.onDidChangeInlayHints.fire();
			});
			const [id, options] = this.getRegistration(documentSelector, capabilities.inlayHintProvider);
			if (!id || !options) return;
			this.register({
				id,
				registerOptions: options
			});
		}
		registerLanguageProvider(options) {
			const selector = options.documentSelector;
			const eventEmitter = new vscode_1.EventEmitter();
			const provider = {
				onDidChangeInlayHints: eventEmitter.event,
				provideInlayHints: (document, viewPort, token) => {
					const client = this._client;
					const provideInlayHints = async (document, viewPort, token) => {
						const requestParams = {
							textDocument: client.code2ProtocolConverter.asTextDocumentIdentifier(document),
							range: client.code2ProtocolConverter.asRange(viewPort)
						};
						try {
							const values = await client.sendRequest(vscode_languageserver_protocol_1.InlayHintRequest.type, requestParams, token);
							if (token.isCancellationRequested) return null;
							return client.protocol2CodeConverter.asInlayHints(values, token);
						} catch (error) {
							return client.handleFailedRequest(vscode_languageserver_protocol_1.InlayHintRequest.type, token, error, null);
						}
					};
					const middleware = client.middleware;
					return middleware.provideInlayHints ? middleware.provideInlayHints(document, viewPort, token, provideInlayHints) : provideInlayHints(document, viewPort, token);
				}
			};
			provider.resolveInlayHint = options.resolveProvider === true ? (hint, token) => {
				const client = this._client;
				const resolveInlayHint = async (item, token) => {
					try {
						const value = await client.sendRequest(vscode_languageserver_protocol_1.InlayHintResolveRequest.type, client.code2ProtocolConverter.asInlayHint(item), token);
						if (token.isCancellationRequested) return null;
						const result = client.protocol2CodeConverter.asInlayHint(value, token);
						return token.isCancellationRequested ? null : result;
					} catch (error) {
						return client.handleFailedRequest(vscode_languageserver_protocol_1.InlayHintResolveRequest.type, token, error, null);
					}
				};
				const middleware = client.middleware;
				return middleware.resolveInlayHint ? middleware.resolveInlayHint(hint, token, resolveInlayHint) : resolveInlayHint(hint, token);
			} : void 0;
			return [this.registerProvider(selector, provider), {
				provider,
				onDidChangeInlayHints: eventEmitter
			}];
		}
		registerProvider(selector, provider) {
			return vscode_1.languages.registerInlayHintsProvider(this._client.protocol2CodeConverter.asDocumentSelector(selector), provider);
		}
	};
	exports.InlayHintsFeature = InlayHintsFeature;
}));
// node_modules/vscode-languageclient/lib/common/workspaceFolder.js
var require_workspaceFolder = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.WorkspaceFoldersFeature = void 0;
	exports.arrayDiff = arrayDiff;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	function access(target, key) {
		if (target === void 0 || target === null) return;
		return target[key];
	}
	function arrayDiff(left, right) {
		return left.filter((element) => right.indexOf(element) < 0);
	}
	var WorkspaceFoldersFeature = class {
		_client;
		_listeners;
		_initialFolders;
		constructor(client) {
			this._client = client;
			this._listeners = /* @__PURE__ */ new Map();
		}
		getState() {
			return {
				kind: "workspace",
				id: this.registrationType.method,
				registrations: this._listeners.size > 0
			};
		}
		get registrationType() {
			return vscode_languageserver_protocol_1.DidChangeWorkspaceFoldersNotification.type;
		}
		fillInitializeParams(params) {
			const folders = vscode_1.workspace.workspaceFolders;
			this.initializeWithFolders(folders);
			if (folders === void 0) params.workspaceFolders = null;
			else params.workspaceFolders = folders.map((folder) => this.asProtocol(folder));
		}
		initializeWithFolders(currentWorkspaceFolders) {
			this._initialFolders = currentWorkspaceFolders;
		}
		fillClientCapabilities(capabilities) {
			capabilities.workspace = capabilities.workspace || {};
			capabilities.workspace.workspaceFolders = true;
		}
		initialize(capabilities) {
			const client = this._client;
			client.onRequest(vscode_languageserver_protocol_1.WorkspaceFoldersRequest.type, (token) => {
				const workspaceFolders = () => {
					const folders = vscode_1.workspace.workspaceFolders;
					if (folders === void 0) return null;
					return folders.map((folder) => {
						return this.asProtocol(folder);
					});
				};
				const middleware = client.middleware.workspace;
				return middleware && middleware.workspaceFolders ? middleware.workspaceFolders(token, workspaceFolders) : workspaceFolders(token);
			});
			const value = access(access(access(capabilities, "workspace"), "workspaceFolders"), "changeNotifications");
			let id;
			if (typeof value === "string") id = value;
			else if (value === true) id = (0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID();
			if (id) this.register({
				id,
				registerOptions: void 0
			});
		}
		sendInitialEvent(currentWorkspaceFolders) {
			let promise;
			if (this._initialFolders && currentWorkspaceFolders) {
				const removed = arrayDiff(this._initialFolders, currentWorkspaceFolders);
				const added = arrayDiff(currentWorkspaceFolders, this._initialFolders);
				if (added.length > 0 || removed.length > 0) promise = this.doSendEvent(added, removed);
			} else if (this._initialFolders) promise = this.doSendEvent([], this._initialFolders);
			else if (currentWorkspaceFolders) promise = this.doSendEvent(currentWorkspaceFolders, []);
			if (promise !== void 0) promise.catch((error) => {
				this._client.error(`Sending notification ${vscode_languageserver_protocol_1.DidChangeWorkspaceFoldersNotification.type.method} failed`, error);
			});
		}
		doSendEvent(addedFolders, removedFolders) {
			const params = { event: {
				added: addedFolders.map((folder) => this.asProtocol(folder)),
				removed: removedFolders.map((folder) => this.asProtocol(folder))
			} };
			return this._client.sendNotification(vscode_languageserver_protocol_1.DidChangeWorkspaceFoldersNotification.type, params);
		}
		register(data) {
			const id = data.id;
			const client = this._client;
			const disposable = vscode_1.workspace.onDidChangeWorkspaceFolders((event) => {
				const didChangeWorkspaceFolders = (event) => {
					return this.doSendEvent(event.added, event.removed);
				};
				const middleware = client.middleware.workspace;
				(middleware && middleware.didChangeWorkspaceFolders ? middleware.didChangeWorkspaceFolders(event, didChangeWorkspaceFolders) : didChangeWorkspaceFolders(event)).catch((error) => {
					this._client.error(`Sending notification ${vscode_languageserver_protocol_1.DidChangeWorkspaceFoldersNotification.type.method} failed`, error);
				});
			});
			this._listeners.set(id, disposable);
			this.sendInitialEvent(vscode_1.workspace.workspaceFolders);
		}
		unregister(id) {
			const disposable = this._listeners.get(id);
			if (disposable === void 0) return;
			this._listeners.delete(id);
			disposable.dispose();
		}
		clear() {
			for (const disposable of this._listeners.values()) disposable.dispose();
			this._listeners.clear();
		}
		asProtocol(workspaceFolder) {
			if (workspaceFolder === void 0) return null;
			return {
				uri: this._client.code2ProtocolConverter.asUri(workspaceFolder.uri),
				name: workspaceFolder.name
			};
		}
	};
	exports.WorkspaceFoldersFeature = WorkspaceFoldersFeature;
}));
// node_modules/vscode-languageclient/lib/common/fileOperations.js
var require_fileOperations = /* @__PURE__ */ __commonJSMin(((exports, module, this$8) => {
	var __createBinding = this$8 && this$8.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$8 && this$8.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$8 && this$8.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.WillDeleteFilesFeature = exports.WillRenameFilesFeature = exports.WillCreateFilesFeature = exports.DidDeleteFilesFeature = exports.DidRenameFilesFeature = exports.DidCreateFilesFeature = void 0;
	var code = __importStar(require("vscode"));
	var minimatch = __importStar(require_commonjs());
	var proto = __importStar(require_api$1());
	function ensure(target, key) {
		if (target[key] === void 0) target[key] = {};
		return target[key];
	}
	function access(target, key) {
		return target[key];
	}
	function assign(target, key, value) {
		target[key] = value;
	}
	var FileOperationFeature = class FileOperationFeature {
		_client;
		_event;
		_registrationType;
		_clientCapability;
		_serverCapability;
		_listener;
		_filters;
		constructor(client, event, registrationType, clientCapability, serverCapability) {
			this._client = client;
			this._event = event;
			this._registrationType = registrationType;
			this._clientCapability = clientCapability;
			this._serverCapability = serverCapability;
			this._filters = /* @__PURE__ */ new Map();
		}
		getState() {
			return {
				kind: "workspace",
				id: this._registrationType.method,
				registrations: this._filters.size > 0
			};
		}
		filterSize() {
			return this._filters.size;
		}
		get registrationType() {
			return this._registrationType;
		}
		fillClientCapabilities(capabilities) {
			const value = ensure(ensure(capabilities, "workspace"), "fileOperations");
			assign(value, "dynamicRegistration", true);
			assign(value, this._clientCapability, true);
		}
		initialize(capabilities) {
			const options = capabilities.workspace?.fileOperations;
			const capability = options !== void 0 ? access(options, this._serverCapability) : void 0;
			if (capability?.filters !== void 0) try {
				this.register({
					id: proto.RAL().crypto.randomUUID(),
					registerOptions: { filters: capability.filters }
				});
			} catch (e) {
				this._client.warn(`Ignoring invalid glob pattern for ${this._serverCapability} registration: ${e}`);
			}
		}
		register(data) {
			if (!this._listener) this._listener = this._event(this.send, this);
			const minimatchFilter = data.registerOptions.filters.map((filter) => {
				const matcher = new minimatch.Minimatch(filter.pattern.glob, FileOperationFeature.asMinimatchOptions(filter.pattern.options));
				if (!matcher.makeRe()) throw new Error(`Invalid pattern ${filter.pattern.glob}!`);
				return {
					scheme: filter.scheme,
					matcher,
					kind: filter.pattern.matches
				};
			});
			this._filters.set(data.id, minimatchFilter);
		}
		unregister(id) {
			this._filters.delete(id);
			if (this._filters.size === 0 && this._listener) {
				this._listener.dispose();
				this._listener = void 0;
			}
		}
		clear() {
			this._filters.clear();
			if (this._listener) {
				this._listener.dispose();
				this._listener = void 0;
			}
		}
		getFileType(uri) {
			return FileOperationFeature.getFileType(uri);
		}
		async filter(event, prop) {
			const fileMatches = await Promise.all(event.files.map(async (item) => {
				const uri = prop(item);
				const path = uri.fsPath.replace(/\\/g, "/");
				for (const filters of this._filters.values()) for (const filter of filters) {
					if (filter.scheme !== void 0 && filter.scheme !== uri.scheme) continue;
					if (filter.matcher.match(path)) {
						if (filter.kind === void 0) return true;
						const fileType = await this.getFileType(uri);
						if (fileType === void 0) {
							this._client.info(`Unable to determine file type for ${uri.toString()}. Treating as a match.`);
							return true;
						}
						if (fileType === code.FileType.File && filter.kind === proto.FileOperationPatternKind.file || fileType === code.FileType.Directory && filter.kind === proto.FileOperationPatternKind.folder) return true;
					} else if (filter.kind === proto.FileOperationPatternKind.folder) {
						if (await FileOperationFeature.getFileType(uri) === code.FileType.Directory && filter.matcher.match(`${path}/`)) return true;
					}
				}
				return false;
			}));
			const files = event.files.filter((_, index) => fileMatches[index]);
			return {
				...event,
				files
			};
		}
		static async getFileType(uri) {
			try {
				return (await code.workspace.fs.stat(uri)).type;
			} catch (e) {
				return;
			}
		}
		static asMinimatchOptions(options) {
			const result = { dot: true };
			if (options?.ignoreCase === true) result.nocase = true;
			return result;
		}
	};
	var NotificationFileOperationFeature = class extends FileOperationFeature {
		_notificationType;
		_accessUri;
		_createParams;
		constructor(client, event, notificationType, clientCapability, serverCapability, accessUri, createParams) {
			super(client, event, notificationType, clientCapability, serverCapability);
			this._notificationType = notificationType;
			this._accessUri = accessUri;
			this._createParams = createParams;
		}
		async send(originalEvent) {
			const filteredEvent = await this.filter(originalEvent, this._accessUri);
			if (filteredEvent.files.length) {
				const next = async (event) => {
					return this._client.sendNotification(this._notificationType, this._createParams(event));
				};
				return this.doSend(filteredEvent, next);
			}
		}
	};
	var CachingNotificationFileOperationFeature = class extends NotificationFileOperationFeature {
		_willListener;
		_fsPathFileTypes = /* @__PURE__ */ new Map();
		async getFileType(uri) {
			const fsPath = uri.fsPath;
			if (this._fsPathFileTypes.has(fsPath)) return this._fsPathFileTypes.get(fsPath);
			const type = await FileOperationFeature.getFileType(uri);
			if (type) this._fsPathFileTypes.set(fsPath, type);
			return type;
		}
		async cacheFileTypes(event, prop) {
			await this.filter(event, prop);
		}
		clearFileTypeCache() {
			this._fsPathFileTypes.clear();
		}
		unregister(id) {
			super.unregister(id);
			if (this.filterSize() === 0 && this._willListener) {
				this._willListener.dispose();
				this._willListener = void 0;
			}
		}
		clear() {
			super.clear();
			if (this._willListener) {
				this._willListener.dispose();
				this._willListener = void 0;
			}
		}
	};
	var DidCreateFilesFeature = class extends NotificationFileOperationFeature {
		constructor(client) {
			super(client, code.workspace.onDidCreateFiles, proto.DidCreateFilesNotification.type, "didCreate", "didCreate", (i) => i, client.code2ProtocolConverter.asDidCreateFilesParams);
		}
		doSend(event, next) {
			const middleware = this._client.middleware.workspace;
			return middleware?.didCreateFiles ? middleware.didCreateFiles(event, next) : next(event);
		}
	};
	exports.DidCreateFilesFeature = DidCreateFilesFeature;
	var DidRenameFilesFeature = class extends CachingNotificationFileOperationFeature {
		constructor(client) {
			super(client, code.workspace.onDidRenameFiles, proto.DidRenameFilesNotification.type, "didRename", "didRename", (i) => i.oldUri, client.code2ProtocolConverter.asDidRenameFilesParams);
		}
		register(data) {
			if (!this._willListener) this._willListener = code.workspace.onWillRenameFiles(this.willRename, this);
			super.register(data);
		}
		willRename(e) {
			e.waitUntil(this.cacheFileTypes(e, (i) => i.oldUri));
		}
		doSend(event, next) {
			this.clearFileTypeCache();
			const middleware = this._client.middleware.workspace;
			return middleware?.didRenameFiles ? middleware.didRenameFiles(event, next) : next(event);
		}
	};
	exports.DidRenameFilesFeature = DidRenameFilesFeature;
	var DidDeleteFilesFeature = class extends CachingNotificationFileOperationFeature {
		constructor(client) {
			super(client, code.workspace.onDidDeleteFiles, proto.DidDeleteFilesNotification.type, "didDelete", "didDelete", (i) => i, client.code2ProtocolConverter.asDidDeleteFilesParams);
		}
		register(data) {
			if (!this._willListener) this._willListener = code.workspace.onWillDeleteFiles(this.willDelete, this);
			super.register(data);
		}
		willDelete(e) {
			e.waitUntil(this.cacheFileTypes(e, (i) => i));
		}
		doSend(event, next) {
			this.clearFileTypeCache();
			const middleware = this._client.middleware.workspace;
			return middleware?.didDeleteFiles ? middleware.didDeleteFiles(event, next) : next(event);
		}
	};
	exports.DidDeleteFilesFeature = DidDeleteFilesFeature;
	var RequestFileOperationFeature = class extends FileOperationFeature {
		_requestType;
		_accessUri;
		_createParams;
		constructor(client, event, requestType, clientCapability, serverCapability, accessUri, createParams) {
			super(client, event, requestType, clientCapability, serverCapability);
			this._requestType = requestType;
			this._accessUri = accessUri;
			this._createParams = createParams;
		}
		async send(originalEvent) {
			const waitUntil = this.waitUntil(originalEvent);
			originalEvent.waitUntil(waitUntil);
		}
		async waitUntil(originalEvent) {
			const filteredEvent = await this.filter(originalEvent, this._accessUri);
			if (filteredEvent.files.length) {
				const next = (event) => {
					return this._client.sendRequest(this._requestType, this._createParams(event), event.token).then(this._client.protocol2CodeConverter.asWorkspaceEdit);
				};
				return this.doSend(filteredEvent, next);
			} else return;
		}
	};
	var WillCreateFilesFeature = class extends RequestFileOperationFeature {
		constructor(client) {
			super(client, code.workspace.onWillCreateFiles, proto.WillCreateFilesRequest.type, "willCreate", "willCreate", (i) => i, client.code2ProtocolConverter.asWillCreateFilesParams);
		}
		doSend(event, next) {
			const middleware = this._client.middleware.workspace;
			return middleware?.willCreateFiles ? middleware.willCreateFiles(event, next) : next(event);
		}
	};
	exports.WillCreateFilesFeature = WillCreateFilesFeature;
	var WillRenameFilesFeature = class extends RequestFileOperationFeature {
		constructor(client) {
			super(client, code.workspace.onWillRenameFiles, proto.WillRenameFilesRequest.type, "willRename", "willRename", (i) => i.oldUri, client.code2ProtocolConverter.asWillRenameFilesParams);
		}
		doSend(event, next) {
			const middleware = this._client.middleware.workspace;
			return middleware?.willRenameFiles ? middleware.willRenameFiles(event, next) : next(event);
		}
	};
	exports.WillRenameFilesFeature = WillRenameFilesFeature;
	var WillDeleteFilesFeature = class extends RequestFileOperationFeature {
		constructor(client) {
			super(client, code.workspace.onWillDeleteFiles, proto.WillDeleteFilesRequest.type, "willDelete", "willDelete", (i) => i, client.code2ProtocolConverter.asWillDeleteFilesParams);
		}
		doSend(event, next) {
			const middleware = this._client.middleware.workspace;
			return middleware?.willDeleteFiles ? middleware.willDeleteFiles(event, next) : next(event);
		}
	};
	exports.WillDeleteFilesFeature = WillDeleteFilesFeature;
}));
// node_modules/vscode-languageclient/lib/common/inlineCompletion.js
var require_inlineCompletion = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.InlineCompletionItemFeature = void 0;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var features_1 = require_features();
	var InlineCompletionItemFeature = class extends features_1.TextDocumentLanguageFeature {
		constructor(client) {
			super(client, vscode_languageserver_protocol_1.InlineCompletionRequest.type);
		}
		fillClientCapabilities(capabilities) {
			const inlineCompletion = (0, features_1.ensure)((0, features_1.ensure)(capabilities, "textDocument"), "inlineCompletion");
			inlineCompletion.dynamicRegistration = true;
		}
		initialize(capabilities, documentSelector) {
			const options = this.getRegistrationOptions(documentSelector, capabilities.inlineCompletionProvider);
			if (!options) return;
			this.register({
				id: (0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID(),
				registerOptions: options
			});
		}
		registerLanguageProvider(options) {
			const selector = options.documentSelector;
			const provider = { provideInlineCompletionItems: (document, position, context, token) => {
				const client = this._client;
				const middleware = this._client.middleware;
				const provideInlineCompletionItems = (document, position, context, token) => {
					return client.sendRequest(vscode_languageserver_protocol_1.InlineCompletionRequest.type, client.code2ProtocolConverter.asInlineCompletionParams(document, position, context), token).then((result) => {
						if (token.isCancellationRequested) return null;
						return client.protocol2CodeConverter.asInlineCompletionResult(result, token);
					}, (error) => {
						return client.handleFailedRequest(vscode_languageserver_protocol_1.InlineCompletionRequest.type, token, error, null);
					});
				};
				return middleware.provideInlineCompletionItems ? middleware.provideInlineCompletionItems(document, position, context, token, provideInlineCompletionItems) : provideInlineCompletionItems(document, position, context, token);
			} };
			return [vscode_1.languages.registerInlineCompletionItemProvider(this._client.protocol2CodeConverter.asDocumentSelector(selector), provider), provider];
		}
	};
	exports.InlineCompletionItemFeature = InlineCompletionItemFeature;
}));
// node_modules/vscode-languageclient/lib/common/textDocumentContent.js
var require_textDocumentContent = /* @__PURE__ */ __commonJSMin(((exports, module, this$7) => {
	var __createBinding = this$7 && this$7.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$7 && this$7.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$7 && this$7.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.TextDocumentContentFeature = void 0;
	var vscode = __importStar(require("vscode"));
	var vscode_languageserver_protocol_1 = require_api$1();
	var features_1 = require_features();
	var TextDocumentContentFeature = class {
		_client;
		_registrations = /* @__PURE__ */ new Map();
		constructor(client) {
			this._client = client;
		}
		getState() {
			const registrations = this._registrations.size > 0;
			return {
				kind: "workspace",
				id: vscode_languageserver_protocol_1.TextDocumentContentRequest.method,
				registrations
			};
		}
		get registrationType() {
			return vscode_languageserver_protocol_1.TextDocumentContentRequest.type;
		}
		getProviders() {
			const result = [];
			for (const registration of this._registrations.values()) result.push(...registration.providers);
			return result;
		}
		fillClientCapabilities(capabilities) {
			const textDocumentContent = (0, features_1.ensure)((0, features_1.ensure)(capabilities, "workspace"), "textDocumentContent");
			textDocumentContent.dynamicRegistration = true;
		}
		initialize(capabilities) {
			const client = this._client;
			client.onRequest(vscode_languageserver_protocol_1.TextDocumentContentRefreshRequest.type, async (params) => {
				const uri = client.protocol2CodeConverter.asUri(params.uri);
				for (const registrations of this._registrations.values()) for (const provider of registrations.providers) if (provider.scheme === uri.scheme) provider.onDidChangeEmitter.fire(uri);
			});
			if (!capabilities?.workspace?.textDocumentContent) return;
			const capability = capabilities.workspace.textDocumentContent;
			const id = vscode_languageserver_protocol_1.StaticRegistrationOptions.hasId(capability) ? capability.id : (0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID();
			this.register({
				id,
				registerOptions: capability
			});
		}
		register(data) {
			const registrations = [];
			const disposables = [];
			for (const scheme of data.registerOptions.schemes) {
				const [disposable, registration] = this.registerTextDocumentContentProvider(scheme);
				registrations.push(registration);
				disposables.push(disposable);
			}
			this._registrations.set(data.id, {
				disposable: vscode.Disposable.from(...disposables),
				providers: registrations
			});
		}
		registerTextDocumentContentProvider(scheme) {
			const eventEmitter = new vscode.EventEmitter();
			const provider = {
				onDidChange: eventEmitter.event,
				provideTextDocumentContent: (uri, token) => {
					const client = this._client;
					const provideTextDocumentContent = (uri, token) => {
						const params = { uri: client.code2ProtocolConverter.asUri(uri) };
						return client.sendRequest(vscode_languageserver_protocol_1.TextDocumentContentRequest.type, params, token).then((result) => {
							if (token.isCancellationRequested) return null;
							return result.text;
						}, (error) => {
							return client.handleFailedRequest(vscode_languageserver_protocol_1.TextDocumentContentRequest.type, token, error, null);
						});
					};
					const middleware = client.middleware;
					return middleware.provideTextDocumentContent ? middleware.provideTextDocumentContent(uri, token, provideTextDocumentContent) : provideTextDocumentContent(uri, token);
				}
			};
			return [vscode.workspace.registerTextDocumentContentProvider(scheme, provider), {
				scheme,
				onDidChangeEmitter: eventEmitter,
				provider
			}];
		}
		unregister(id) {
			const registration = this._registrations.get(id);
			if (registration !== void 0) {
				this._registrations.delete(id);
				registration.disposable.dispose();
			}
		}
		clear() {
			this._registrations.forEach((registration) => {
				registration.disposable.dispose();
			});
			this._registrations.clear();
		}
	};
	exports.TextDocumentContentFeature = TextDocumentContentFeature;
}));
// node_modules/vscode-languageclient/lib/common/fileSystemWatcher.js
var require_fileSystemWatcher = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.FileSystemWatcherFeature = void 0;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var features_1 = require_features();
	var FileSystemWatcherFeature = class {
		_client;
		_notifyFileEvent;
		_watchers;
		constructor(client, notifyFileEvent) {
			this._client = client;
			this._notifyFileEvent = notifyFileEvent;
			this._watchers = /* @__PURE__ */ new Map();
		}
		getState() {
			return {
				kind: "workspace",
				id: this.registrationType.method,
				registrations: this._watchers.size > 0
			};
		}
		get registrationType() {
			return vscode_languageserver_protocol_1.DidChangeWatchedFilesNotification.type;
		}
		fillClientCapabilities(capabilities) {
			(0, features_1.ensure)((0, features_1.ensure)(capabilities, "workspace"), "didChangeWatchedFiles").dynamicRegistration = true;
			(0, features_1.ensure)((0, features_1.ensure)(capabilities, "workspace"), "didChangeWatchedFiles").relativePatternSupport = true;
		}
		initialize(_capabilities, _documentSelector) {}
		register(data) {
			if (!Array.isArray(data.registerOptions.watchers)) return;
			this.unregister(data.id);
			const disposables = [];
			for (const watcher of data.registerOptions.watchers) {
				const globPattern = this._client.protocol2CodeConverter.asGlobPattern(watcher.globPattern);
				if (globPattern === void 0) continue;
				let watchCreate = true, watchChange = true, watchDelete = true;
				if (watcher.kind !== void 0 && watcher.kind !== null) {
					watchCreate = (watcher.kind & vscode_languageserver_protocol_1.WatchKind.Create) !== 0;
					watchChange = (watcher.kind & vscode_languageserver_protocol_1.WatchKind.Change) !== 0;
					watchDelete = (watcher.kind & vscode_languageserver_protocol_1.WatchKind.Delete) !== 0;
				}
				const fileSystemWatcher = vscode_1.workspace.createFileSystemWatcher(globPattern, !watchCreate, !watchChange, !watchDelete);
				this.hookListeners(fileSystemWatcher, watchCreate, watchChange, watchDelete, disposables);
				disposables.push(fileSystemWatcher);
			}
			this._watchers.set(data.id, disposables);
		}
		registerRaw(id, fileSystemWatchers) {
			this.unregister(id);
			const disposables = [];
			for (const fileSystemWatcher of fileSystemWatchers) this.hookListeners(fileSystemWatcher, true, true, true, disposables);
			this._watchers.set(id, disposables);
		}
		hookListeners(fileSystemWatcher, watchCreate, watchChange, watchDelete, listeners) {
			if (watchCreate) fileSystemWatcher.onDidCreate((resource) => this._notifyFileEvent({
				uri: this._client.code2ProtocolConverter.asUri(resource),
				type: vscode_languageserver_protocol_1.FileChangeType.Created
			}), null, listeners);
			if (watchChange) fileSystemWatcher.onDidChange((resource) => this._notifyFileEvent({
				uri: this._client.code2ProtocolConverter.asUri(resource),
				type: vscode_languageserver_protocol_1.FileChangeType.Changed
			}), null, listeners);
			if (watchDelete) fileSystemWatcher.onDidDelete((resource) => this._notifyFileEvent({
				uri: this._client.code2ProtocolConverter.asUri(resource),
				type: vscode_languageserver_protocol_1.FileChangeType.Deleted
			}), null, listeners);
		}
		unregister(id) {
			const disposables = this._watchers.get(id);
			if (disposables) {
				this._watchers.delete(id);
				for (const disposable of disposables) disposable.dispose();
			}
		}
		clear() {
			this._watchers.forEach((disposables) => {
				for (const disposable of disposables) disposable.dispose();
			});
			this._watchers.clear();
		}
	};
	exports.FileSystemWatcherFeature = FileSystemWatcherFeature;
}));
// node_modules/vscode-languageclient/lib/common/progress.js
var require_progress = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.ProgressFeature = void 0;
	var vscode_languageserver_protocol_1 = require_api$1();
	var progressPart_1 = require_progressPart();
	function ensure(target, key) {
		if (target[key] === void 0) target[key] = Object.create(null);
		return target[key];
	}
	var ProgressFeature = class {
		_client;
		activeParts;
		constructor(_client) {
			this._client = _client;
			this.activeParts = /* @__PURE__ */ new Set();
		}
		getState() {
			return {
				kind: "window",
				id: vscode_languageserver_protocol_1.WorkDoneProgressCreateRequest.method,
				registrations: this.activeParts.size > 0
			};
		}
		fillClientCapabilities(capabilities) {
			ensure(capabilities, "window").workDoneProgress = true;
		}
		initialize() {
			const client = this._client;
			const deleteHandler = (part) => {
				this.activeParts.delete(part);
			};
			const createHandler = (params) => {
				this.activeParts.add(new progressPart_1.ProgressPart(this._client, params.token, deleteHandler));
			};
			client.onRequest(vscode_languageserver_protocol_1.WorkDoneProgressCreateRequest.type, createHandler);
		}
		clear() {
			for (const part of this.activeParts) part.done();
			this.activeParts.clear();
		}
	};
	exports.ProgressFeature = ProgressFeature;
}));
// node_modules/vscode-languageclient/lib/common/client.js
var require_client = /* @__PURE__ */ __commonJSMin(((exports, module, this$6) => {
	var __createBinding = this$6 && this$6.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$6 && this$6.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$6 && this$6.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.ProposedFeatures = exports.LanguageClient = exports.BaseLanguageClient = exports.ShutdownMode = exports.MessageTransports = exports.SuspendMode = exports.State = exports.CloseAction = exports.ErrorAction = exports.RevealOutputChannelOn = void 0;
	var vscode_1 = require("vscode");
	var vscode_languageserver_protocol_1 = require_api$1();
	var c2p = __importStar(require_codeConverter());
	var p2c = __importStar(require_protocolConverter());
	var Is = __importStar(require_is$2());
	var async_1 = require_async();
	var progressPart_1 = require_progressPart();
	var features_1 = require_features();
	var diagnostic_1 = require_diagnostic();
	var notebook_1 = require_notebook();
	var configuration_1 = require_configuration();
	var textSynchronization_1 = require_textSynchronization();
	var completion_1 = require_completion();
	var hover_1 = require_hover();
	var definition_1 = require_definition();
	var signatureHelp_1 = require_signatureHelp();
	var documentHighlight_1 = require_documentHighlight();
	var documentSymbol_1 = require_documentSymbol();
	var workspaceSymbol_1 = require_workspaceSymbol();
	var reference_1 = require_reference();
	var typeDefinition_1 = require_typeDefinition();
	var implementation_1 = require_implementation();
	var colorProvider_1 = require_colorProvider();
	var codeAction_1 = require_codeAction();
	var codeLens_1 = require_codeLens();
	var formatting_1 = require_formatting();
	var rename_1 = require_rename();
	var documentLink_1 = require_documentLink();
	var executeCommand_1 = require_executeCommand();
	var foldingRange_1 = require_foldingRange();
	var declaration_1 = require_declaration();
	var selectionRange_1 = require_selectionRange();
	var callHierarchy_1 = require_callHierarchy();
	var semanticTokens_1 = require_semanticTokens();
	var linkedEditingRange_1 = require_linkedEditingRange();
	var typeHierarchy_1 = require_typeHierarchy();
	var inlineValue_1 = require_inlineValue();
	var inlayHint_1 = require_inlayHint();
	var workspaceFolder_1 = require_workspaceFolder();
	var fileOperations_1 = require_fileOperations();
	var inlineCompletion_1 = require_inlineCompletion();
	var textDocumentContent_1 = require_textDocumentContent();
	var fileSystemWatcher_1 = require_fileSystemWatcher();
	var progress_1 = require_progress();
	/**
	* Controls when the output channel is revealed.
	*/
	var RevealOutputChannelOn;
	(function(RevealOutputChannelOn) {
		RevealOutputChannelOn[RevealOutputChannelOn["Debug"] = 0] = "Debug";
		RevealOutputChannelOn[RevealOutputChannelOn["Info"] = 1] = "Info";
		RevealOutputChannelOn[RevealOutputChannelOn["Warn"] = 2] = "Warn";
		RevealOutputChannelOn[RevealOutputChannelOn["Error"] = 3] = "Error";
		RevealOutputChannelOn[RevealOutputChannelOn["Never"] = 4] = "Never";
	})(RevealOutputChannelOn || (exports.RevealOutputChannelOn = RevealOutputChannelOn = {}));
	/**
	* An action to be performed when the connection is producing errors.
	*/
	var ErrorAction;
	(function(ErrorAction) {
		/**
		* Continue running the server.
		*/
		ErrorAction[ErrorAction["Continue"] = 1] = "Continue";
		/**
		* Shutdown the server.
		*/
		ErrorAction[ErrorAction["Shutdown"] = 2] = "Shutdown";
	})(ErrorAction || (exports.ErrorAction = ErrorAction = {}));
	/**
	* An action to be performed when the connection to a server got closed.
	*/
	var CloseAction;
	(function(CloseAction) {
		/**
		* Don't restart the server. The connection stays closed.
		*/
		CloseAction[CloseAction["DoNotRestart"] = 1] = "DoNotRestart";
		/**
		* Restart the server.
		*/
		CloseAction[CloseAction["Restart"] = 2] = "Restart";
	})(CloseAction || (exports.CloseAction = CloseAction = {}));
	/**
	* Signals in which state the language client is in.
	*/
	var State;
	(function(State) {
		/**
		* The client is stopped or got never started.
		*/
		State[State["Stopped"] = 1] = "Stopped";
		/**
		* The client is starting but not ready yet.
		*/
		State[State["Starting"] = 3] = "Starting";
		/**
		* The start has failed.
		*/
		State[State["StartFailed"] = 4] = "StartFailed";
		/**
		* The client is running and ready.
		*/
		State[State["Running"] = 2] = "Running";
	})(State || (exports.State = State = {}));
	var SuspendMode;
	(function(SuspendMode) {
		/**
		* Don't allow suspend mode.
		*/
		SuspendMode["off"] = "off";
		/**
		* Support suspend mode even if not all
		* registered providers have a corresponding
		* activation listener.
		*/
		SuspendMode["on"] = "on";
	})(SuspendMode || (exports.SuspendMode = SuspendMode = {}));
	var ResolvedClientOptions;
	(function(ResolvedClientOptions) {
		function sanitizeIsTrusted(isTrusted) {
			if (isTrusted === void 0 || isTrusted === null) return false;
			if (typeof isTrusted === "boolean" || typeof isTrusted === "object" && isTrusted !== null && Is.stringArray(isTrusted.enabledCommands)) return isTrusted;
			return false;
		}
		ResolvedClientOptions.sanitizeIsTrusted = sanitizeIsTrusted;
	})(ResolvedClientOptions || (ResolvedClientOptions = {}));
	var DefaultErrorHandler = class {
		client;
		maxRestartCount;
		restarts;
		constructor(client, maxRestartCount) {
			this.client = client;
			this.maxRestartCount = maxRestartCount;
			this.restarts = [];
		}
		error(_error, _message, count) {
			if (count && count <= 3) return { action: ErrorAction.Continue };
			return { action: ErrorAction.Shutdown };
		}
		closed() {
			this.restarts.push(Date.now());
			if (this.restarts.length <= this.maxRestartCount) return { action: CloseAction.Restart };
			else if (this.restarts[this.restarts.length - 1] - this.restarts[0] <= 18e4) return {
				action: CloseAction.DoNotRestart,
				message: `The ${this.client.name} server crashed ${this.maxRestartCount + 1} times in the last 3 minutes. The server will not be restarted. See the output for more information.`
			};
			else {
				this.restarts.shift();
				return { action: CloseAction.Restart };
			}
		}
	};
	var ClientState;
	(function(ClientState) {
		ClientState["Initial"] = "initial";
		ClientState["Starting"] = "starting";
		ClientState["StartFailed"] = "startFailed";
		ClientState["Running"] = "running";
		ClientState["Stopping"] = "stopping";
		ClientState["Stopped"] = "stopped";
	})(ClientState || (ClientState = {}));
	var MessageTransports;
	(function(MessageTransports) {
		function is(value) {
			return value && vscode_languageserver_protocol_1.MessageReader.is(value.reader) && vscode_languageserver_protocol_1.MessageWriter.is(value.writer);
		}
		MessageTransports.is = is;
	})(MessageTransports || (exports.MessageTransports = MessageTransports = {}));
	var ShutdownMode;
	(function(ShutdownMode) {
		ShutdownMode["Restart"] = "restart";
		ShutdownMode["Stop"] = "stop";
	})(ShutdownMode || (exports.ShutdownMode = ShutdownMode = {}));
	/**
	* Manages the open tabs. We don't directly use the tab API since for
	* diagnostics we need to de-dupe tabs that show the same resources since
	* we pull on the model not the UI.
	*/
	var VisibleDocumentsImpl = class VisibleDocumentsImpl {
		open;
		_onOpen;
		_onClose;
		disposables;
		constructor() {
			this.disposables = [];
			this.open = /* @__PURE__ */ new Set();
			this._onOpen = new vscode_1.EventEmitter();
			this._onClose = new vscode_1.EventEmitter();
			VisibleDocumentsImpl.fillVisibleResources(this.open);
			const updateVisibleDocuments = () => {
				const oldTabs = this.open;
				const currentTabs = /* @__PURE__ */ new Set();
				VisibleDocumentsImpl.fillVisibleResources(currentTabs);
				const closed = /* @__PURE__ */ new Set();
				const opened = new Set(currentTabs);
				for (const tab of oldTabs.values()) if (currentTabs.has(tab)) opened.delete(tab);
				else closed.add(tab);
				this.open = currentTabs;
				if (closed.size > 0) {
					const toFire = /* @__PURE__ */ new Set();
					for (const item of closed) toFire.add(vscode_1.Uri.parse(item));
					this._onClose.fire(toFire);
				}
				if (opened.size > 0) {
					const toFire = /* @__PURE__ */ new Set();
					for (const item of opened) toFire.add(vscode_1.Uri.parse(item));
					this._onOpen.fire(toFire);
				}
			};
			this.disposables.push(vscode_1.window.tabGroups.onDidChangeTabs((event) => {
				if (event.closed.length === 0 && event.opened.length === 0) return;
				updateVisibleDocuments();
			}));
			this.disposables.push(vscode_1.window.onDidChangeVisibleTextEditors((_editors) => {
				updateVisibleDocuments();
			}));
		}
		get onClose() {
			return this._onClose.event;
		}
		get onOpen() {
			return this._onOpen.event;
		}
		dispose() {
			this.disposables.forEach((disposable) => disposable.dispose());
		}
		isActive(document) {
			return document instanceof vscode_1.Uri ? vscode_1.window.activeTextEditor?.document.uri === document : vscode_1.window.activeTextEditor?.document === document;
		}
		isVisible(document) {
			const uri = document instanceof vscode_1.Uri ? document : document.uri;
			if (uri.scheme === notebook_1.NotebookDocumentSyncFeature.CellScheme) return vscode_1.workspace.notebookDocuments.some((notebook) => {
				if (this.open.has(notebook.uri.toString())) return notebook.getCells().find((cell) => cell.document.uri.toString() === uri.toString()) !== void 0;
				return false;
			});
			return this.open.has(uri.toString());
		}
		getResources() {
			const result = /* @__PURE__ */ new Set();
			VisibleDocumentsImpl.fillVisibleResources(/* @__PURE__ */ new Set(), result);
			return result;
		}
		static fillVisibleResources(strings, uris) {
			const seen = strings ?? /* @__PURE__ */ new Set();
			for (const group of vscode_1.window.tabGroups.all) for (const tab of group.tabs) {
				const input = tab.input;
				let uri;
				if (input instanceof vscode_1.TabInputText) uri = input.uri;
				else if (input instanceof vscode_1.TabInputTextDiff) uri = input.modified;
				else if (input instanceof vscode_1.TabInputCustom) uri = input.uri;
				else if (input instanceof vscode_1.TabInputNotebook) uri = input.uri;
				if (uri !== void 0 && !seen.has(uri.toString())) {
					seen.add(uri.toString());
					uris !== void 0 && uris.add(uri);
				}
			}
			for (const editor of vscode_1.window.visibleTextEditors) {
				const uri = editor.document.uri;
				if (!seen.has(uri.toString())) {
					seen.add(uri.toString());
					uris !== void 0 && uris.add(uri);
				}
			}
		}
	};
	var BaseLanguageClient = class BaseLanguageClient {
		_id;
		_name;
		_clientOptions;
		_state;
		_onStart;
		_onStop;
		_connection;
		_idleInterval;
		_ignoredRegistrations;
		_listeners;
		_disposed;
		_notificationHandlers;
		_notificationDisposables;
		_pendingNotificationHandlers;
		_requestHandlers;
		_requestDisposables;
		_pendingRequestHandlers;
		_progressHandlers;
		_pendingProgressHandlers;
		_progressDisposables;
		_initializeResult;
		_outputChannel;
		_disposeOutputChannel;
		_traceOutputChannel;
		_traceLogLevel;
		_capabilities;
		_diagnostics;
		_syncedDocuments;
		_didChangeTextDocumentFeature;
		_inFlightOpenNotifications;
		_pendingChangeSemaphore;
		_pendingChangeDelayer;
		_didOpenTextDocumentFeature;
		_fileEvents;
		_fileEventDelayer;
		_telemetryEmitter;
		_stateChangeEmitter;
		_trace;
		_traceFormat = vscode_languageserver_protocol_1.TraceFormat.Text;
		_tracer;
		_c2p;
		_p2c;
		_visibleDocuments;
		constructor(id, name, clientOptions) {
			this._id = id;
			this._name = name;
			clientOptions = clientOptions || {};
			const markdown = {
				isTrusted: false,
				supportHtml: false,
				supportThemeIcons: false
			};
			if (clientOptions.markdown !== void 0) {
				markdown.isTrusted = ResolvedClientOptions.sanitizeIsTrusted(clientOptions.markdown.isTrusted);
				markdown.supportHtml = clientOptions.markdown.supportHtml === true;
				markdown.supportThemeIcons = clientOptions.markdown.supportThemeIcons === true;
			}
			this._clientOptions = {
				documentSelector: clientOptions.documentSelector ?? [],
				synchronize: clientOptions.synchronize ?? {},
				diagnosticCollectionName: clientOptions.diagnosticCollectionName,
				outputChannelName: clientOptions.outputChannelName ?? this._name,
				revealOutputChannelOn: clientOptions.revealOutputChannelOn ?? RevealOutputChannelOn.Error,
				stdioEncoding: clientOptions.stdioEncoding ?? "utf8",
				initializationOptions: clientOptions.initializationOptions,
				initializationFailedHandler: clientOptions.initializationFailedHandler,
				progressOnInitialization: !!clientOptions.progressOnInitialization,
				errorHandler: clientOptions.errorHandler ?? this.createDefaultErrorHandler(clientOptions.connectionOptions?.maxRestartCount),
				middleware: clientOptions.middleware ?? {},
				uriConverters: clientOptions.uriConverters,
				workspaceFolder: clientOptions.workspaceFolder,
				connectionOptions: clientOptions.connectionOptions,
				markdown,
				diagnosticPullOptions: clientOptions.diagnosticPullOptions ?? {
					onChange: true,
					onSave: false
				},
				diagnosticCollectionProvider: clientOptions.diagnosticCollectionProvider ?? new features_1.DefaultDiagnosticCollectionProvider(),
				notebookDocumentOptions: clientOptions.notebookDocumentOptions ?? {},
				textSynchronization: this.createTextSynchronizationOptions(clientOptions.textSynchronization)
			};
			this._clientOptions.synchronize = this._clientOptions.synchronize || {};
			this._state = ClientState.Initial;
			this._ignoredRegistrations = /* @__PURE__ */ new Set();
			this._listeners = [];
			this._notificationHandlers = /* @__PURE__ */ new Map();
			this._pendingNotificationHandlers = /* @__PURE__ */ new Map();
			this._notificationDisposables = /* @__PURE__ */ new Map();
			this._requestHandlers = /* @__PURE__ */ new Map();
			this._pendingRequestHandlers = /* @__PURE__ */ new Map();
			this._requestDisposables = /* @__PURE__ */ new Map();
			this._progressHandlers = /* @__PURE__ */ new Map();
			this._pendingProgressHandlers = /* @__PURE__ */ new Map();
			this._progressDisposables = /* @__PURE__ */ new Map();
			this._connection = void 0;
			this._initializeResult = void 0;
			if (clientOptions.outputChannel) {
				this._outputChannel = clientOptions.outputChannel;
				this._disposeOutputChannel = false;
				this._traceLogLevel = this._outputChannel.logLevel;
			} else {
				this._outputChannel = void 0;
				this._disposeOutputChannel = true;
				this._traceLogLevel = vscode_1.LogLevel.Info;
			}
			this._traceOutputChannel = clientOptions.traceOutputChannel;
			if (this._traceOutputChannel !== void 0) this._traceLogLevel = this._traceOutputChannel.logLevel;
			this._diagnostics = void 0;
			this._inFlightOpenNotifications = /* @__PURE__ */ new Set();
			this._pendingChangeSemaphore = new async_1.Semaphore(1);
			this._pendingChangeDelayer = new async_1.Delayer(250);
			this._fileEvents = [];
			this._fileEventDelayer = new async_1.Delayer(250);
			this._onStop = void 0;
			this._telemetryEmitter = new vscode_languageserver_protocol_1.Emitter();
			this._stateChangeEmitter = new vscode_languageserver_protocol_1.Emitter();
			this._trace = vscode_languageserver_protocol_1.Trace.Off;
			this._tracer = { log: (messageOrDataObject, data) => {
				if (Is.string(messageOrDataObject)) this.trace(messageOrDataObject, data);
				else this.traceObject(messageOrDataObject);
			} };
			this._c2p = c2p.createConverter(clientOptions.uriConverters ? clientOptions.uriConverters.code2Protocol : void 0);
			this._p2c = p2c.createConverter(clientOptions.uriConverters ? clientOptions.uriConverters.protocol2Code : void 0, this._clientOptions.markdown.isTrusted, this._clientOptions.markdown.supportHtml, this._clientOptions.markdown.supportThemeIcons);
			this._syncedDocuments = /* @__PURE__ */ new Map();
			this.registerBuiltinFeatures();
		}
		createTextSynchronizationOptions(options) {
			if (!options) return { delayOpenNotifications: false };
			if (typeof options.delayOpenNotifications === "boolean") return { delayOpenNotifications: options.delayOpenNotifications };
			return { delayOpenNotifications: false };
		}
		get name() {
			return this._name;
		}
		get middleware() {
			return this._clientOptions.middleware ?? Object.create(null);
		}
		get clientOptions() {
			return this._clientOptions;
		}
		get protocol2CodeConverter() {
			return this._p2c;
		}
		get code2ProtocolConverter() {
			return this._c2p;
		}
		get visibleDocuments() {
			if (this._visibleDocuments === void 0) this._visibleDocuments = new VisibleDocumentsImpl();
			return this._visibleDocuments;
		}
		get onTelemetry() {
			return this._telemetryEmitter.event;
		}
		get onDidChangeState() {
			return this._stateChangeEmitter.event;
		}
		get outputChannel() {
			if (!this._outputChannel) {
				this._outputChannel = vscode_1.window.createOutputChannel(this._clientOptions.outputChannelName ? this._clientOptions.outputChannelName : this._name, { log: true });
				if (this._traceOutputChannel === void 0) this._traceLogLevel = this._outputChannel.logLevel;
			}
			return this._outputChannel;
		}
		get traceOutputChannel() {
			return this._traceOutputChannel ? this._traceOutputChannel : this.outputChannel;
		}
		get diagnostics() {
			if (this._diagnostics === null) return;
			if (this._diagnostics === void 0) this._diagnostics = this._clientOptions.diagnosticCollectionProvider.create(this._clientOptions.diagnosticCollectionName ?? this._id, features_1.DiagnosticCollectionSource.push);
			return this._diagnostics;
		}
		get state() {
			return this.getPublicState();
		}
		get $state() {
			return this._state;
		}
		set $state(value) {
			const oldState = this.getPublicState();
			this._state = value;
			const newState = this.getPublicState();
			if (newState !== oldState) this._stateChangeEmitter.fire({
				oldState,
				newState
			});
		}
		getPublicState() {
			switch (this.$state) {
				case ClientState.Starting: return State.Starting;
				case ClientState.Running: return State.Running;
				case ClientState.StartFailed: return State.StartFailed;
				default: return State.Stopped;
			}
		}
		get initializeResult() {
			return this._initializeResult;
		}
		async sendRequest(type, ...params) {
			if (this.$state === ClientState.StartFailed || this.$state === ClientState.Stopping || this.$state === ClientState.Stopped) return Promise.reject(new vscode_languageserver_protocol_1.ResponseError(vscode_languageserver_protocol_1.ErrorCodes.ConnectionInactive, `Client is not running`));
			const connection = await this.$start();
			await this._didOpenTextDocumentFeature.sendPendingOpenNotifications();
			if (this._didChangeTextDocumentFeature.syncKind === vscode_languageserver_protocol_1.TextDocumentSyncKind.Full) await this.sendPendingFullTextDocumentChanges(connection);
			let param = void 0;
			let token = void 0;
			if (params.length === 1) {
				if (vscode_languageserver_protocol_1.CancellationToken.is(params[0])) token = params[0];
				else param = params[0];
			} else if (params.length === 2) {
				param = params[0];
				token = params[1];
			}
			if (token !== void 0 && token.isCancellationRequested) return Promise.reject(new vscode_languageserver_protocol_1.ResponseError(vscode_languageserver_protocol_1.LSPErrorCodes.RequestCancelled, "Request got cancelled"));
			const _sendRequest = this._clientOptions.middleware?.sendRequest;
			if (_sendRequest !== void 0) return _sendRequest(type, param, token, (type, param, token) => {
				const params = [];
				if (param !== void 0) params.push(param);
				if (token !== void 0) params.push(token);
				return connection.sendRequest(type, ...params);
			});
			else return connection.sendRequest(type, ...params);
		}
		onRequest(type, handler) {
			const method = typeof type === "string" ? type : type.method;
			this._requestHandlers.set(method, handler);
			const connection = this.activeConnection();
			let disposable;
			if (connection !== void 0) {
				this._requestDisposables.set(method, connection.onRequest(type, handler));
				disposable = { dispose: () => {
					const disposable = this._requestDisposables.get(method);
					if (disposable !== void 0) {
						disposable.dispose();
						this._requestDisposables.delete(method);
					}
				} };
			} else {
				this._pendingRequestHandlers.set(method, handler);
				disposable = { dispose: () => {
					this._pendingRequestHandlers.delete(method);
					const disposable = this._requestDisposables.get(method);
					if (disposable !== void 0) {
						disposable.dispose();
						this._requestDisposables.delete(method);
					}
				} };
			}
			return { dispose: () => {
				this._requestHandlers.delete(method);
				disposable.dispose();
			} };
		}
		async sendNotification(type, params) {
			if (this.$state === ClientState.StartFailed || this.$state === ClientState.Stopping || this.$state === ClientState.Stopped) return Promise.reject(new vscode_languageserver_protocol_1.ResponseError(vscode_languageserver_protocol_1.ErrorCodes.ConnectionInactive, `Client is not running`));
			const needsPendingFullTextDocumentSync = this._didChangeTextDocumentFeature.syncKind === vscode_languageserver_protocol_1.TextDocumentSyncKind.Full;
			const isOpenNotification = typeof type !== "string" && type.method === vscode_languageserver_protocol_1.DidOpenTextDocumentNotification.method;
			let openNotification;
			if (needsPendingFullTextDocumentSync && isOpenNotification) {
				openNotification = params?.textDocument.uri;
				this._inFlightOpenNotifications.add(openNotification);
			}
			let documentToClose;
			if (typeof type !== "string" && type.method === vscode_languageserver_protocol_1.DidCloseTextDocumentNotification.method) documentToClose = params.textDocument.uri;
			const connection = await this.$start();
			if (documentToClose !== void 0) {
				if (this._didOpenTextDocumentFeature.dropPendingOpenNotification(documentToClose)) return;
			} else if (!isOpenNotification) await this._didOpenTextDocumentFeature.sendPendingOpenNotifications();
			if (needsPendingFullTextDocumentSync) await this.sendPendingFullTextDocumentChanges(connection);
			if (openNotification !== void 0) this._inFlightOpenNotifications.delete(openNotification);
			const _sendNotification = this._clientOptions.middleware?.sendNotification;
			return _sendNotification ? _sendNotification(type, connection.sendNotification.bind(connection), params) : connection.sendNotification(type, params);
		}
		onNotification(type, handler) {
			const method = typeof type === "string" ? type : type.method;
			this._notificationHandlers.set(method, handler);
			const connection = this.activeConnection();
			let disposable;
			if (connection !== void 0) {
				this._notificationDisposables.set(method, connection.onNotification(type, handler));
				disposable = { dispose: () => {
					const disposable = this._notificationDisposables.get(method);
					if (disposable !== void 0) {
						disposable.dispose();
						this._notificationDisposables.delete(method);
					}
				} };
			} else {
				this._pendingNotificationHandlers.set(method, handler);
				disposable = { dispose: () => {
					this._pendingNotificationHandlers.delete(method);
					const disposable = this._notificationDisposables.get(method);
					if (disposable !== void 0) {
						disposable.dispose();
						this._notificationDisposables.delete(method);
					}
				} };
			}
			return { dispose: () => {
				this._notificationHandlers.delete(method);
				disposable.dispose();
			} };
		}
		async sendProgress(type, token, value) {
			if (this.$state === ClientState.StartFailed || this.$state === ClientState.Stopping || this.$state === ClientState.Stopped) return Promise.reject(new vscode_languageserver_protocol_1.ResponseError(vscode_languageserver_protocol_1.ErrorCodes.ConnectionInactive, `Client is not running`));
			try {
				return (await this.$start()).sendProgress(type, token, value);
			} catch (error) {
				this.error(`Sending progress for token ${token} failed.`, error);
				throw error;
			}
		}
		onProgress(type, token, handler) {
			this._progressHandlers.set(token, {
				type,
				handler
			});
			const connection = this.activeConnection();
			let disposable;
			const handleWorkDoneProgress = this._clientOptions.middleware?.handleWorkDoneProgress;
			const realHandler = vscode_languageserver_protocol_1.WorkDoneProgress.is(type) && handleWorkDoneProgress !== void 0 ? (params) => {
				handleWorkDoneProgress(token, params, () => handler(params));
			} : handler;
			if (connection !== void 0) {
				this._progressDisposables.set(token, connection.onProgress(type, token, realHandler));
				disposable = { dispose: () => {
					const disposable = this._progressDisposables.get(token);
					if (disposable !== void 0) {
						disposable.dispose();
						this._progressDisposables.delete(token);
					}
				} };
			} else {
				this._pendingProgressHandlers.set(token, {
					type,
					handler
				});
				disposable = { dispose: () => {
					this._pendingProgressHandlers.delete(token);
					const disposable = this._progressDisposables.get(token);
					if (disposable !== void 0) {
						disposable.dispose();
						this._progressDisposables.delete(token);
					}
				} };
			}
			return { dispose: () => {
				this._progressHandlers.delete(token);
				disposable.dispose();
			} };
		}
		createDefaultErrorHandler(maxRestartCount) {
			if (maxRestartCount !== void 0 && maxRestartCount < 0) throw new Error(`Invalid maxRestartCount: ${maxRestartCount}`);
			return new DefaultErrorHandler(this, maxRestartCount ?? 4);
		}
		async setTrace(value) {
			this._trace = value;
			const connection = this.activeConnection();
			if (connection !== void 0) await connection.trace(this._trace, this._tracer, {
				sendNotification: false,
				traceFormat: this._traceFormat
			});
		}
		data2String(data) {
			if (data instanceof vscode_languageserver_protocol_1.ResponseError) {
				const responseError = data;
				return `  Message: ${responseError.message}\n  Code: ${responseError.code} ${responseError.data ? "\n" + responseError.data.toString() : ""}`;
			}
			if (data instanceof Error) {
				if (Is.string(data.stack)) return data.stack;
				return data.message;
			}
			if (Is.string(data)) return data;
			return data.toString();
		}
		shouldLogToOutputChannel() {
			if (this.$state !== ClientState.Stopped) return true;
			return this._outputChannel !== void 0;
		}
		error(message, data, showNotification = true) {
			if (this.shouldLogToOutputChannel()) this.outputChannel.error(this.getLogMessage(message, data));
			if (showNotification === "force" || showNotification && this._clientOptions.revealOutputChannelOn <= RevealOutputChannelOn.Error) this.showNotificationMessage(vscode_languageserver_protocol_1.MessageType.Error, message, data);
		}
		warn(message, data, showNotification = true) {
			if (this.shouldLogToOutputChannel()) this.outputChannel.warn(this.getLogMessage(message, data));
			if (showNotification && this._clientOptions.revealOutputChannelOn <= RevealOutputChannelOn.Warn) this.showNotificationMessage(vscode_languageserver_protocol_1.MessageType.Warning, message, data);
		}
		info(message, data, showNotification = true) {
			if (this.shouldLogToOutputChannel()) this.outputChannel.info(this.getLogMessage(message, data));
			if (showNotification && this._clientOptions.revealOutputChannelOn <= RevealOutputChannelOn.Info) this.showNotificationMessage(vscode_languageserver_protocol_1.MessageType.Info, message, data);
		}
		debug(message, data, showNotification = true) {
			if (this.shouldLogToOutputChannel()) this.outputChannel.debug(this.getLogMessage(message, data));
			if (showNotification && this._clientOptions.revealOutputChannelOn <= RevealOutputChannelOn.Debug) this.showNotificationMessage(vscode_languageserver_protocol_1.MessageType.Debug, message, data);
		}
		trace(message, data) {
			this.traceOutputChannel.trace(this.getLogMessage(message, data));
		}
		traceObject(data) {
			this.traceOutputChannel.trace(JSON.stringify(data));
		}
		showNotificationMessage(type, message, data) {
			message = message ?? "A request has failed. See the output for more information.";
			if (data) message += "\n" + this.data2String(data);
			(type === vscode_languageserver_protocol_1.MessageType.Error ? vscode_1.window.showErrorMessage : type === vscode_languageserver_protocol_1.MessageType.Warning ? vscode_1.window.showWarningMessage : vscode_1.window.showInformationMessage)(message, "Go to output").then((selection) => {
				if (selection !== void 0) this.outputChannel.show(true);
			});
		}
		getLogMessage(message, data) {
			return data !== null && data !== void 0 ? `${message}\n${this.data2String(data)}` : message;
		}
		needsStart() {
			return this.$state === ClientState.Initial || this.$state === ClientState.Stopping || this.$state === ClientState.Stopped;
		}
		needsStop() {
			return this.$state === ClientState.Starting || this.$state === ClientState.Running;
		}
		activeConnection() {
			return this.$state === ClientState.Running && this._connection !== void 0 ? this._connection : void 0;
		}
		isRunning() {
			return this.$state === ClientState.Running;
		}
		async start() {
			if (this._disposed === "disposing" || this._disposed === "disposed") throw new Error(`Client got disposed and can't be restarted.`);
			if (this.$state === ClientState.Stopping) throw new Error(`Client is currently stopping. Can only restart a full stopped client`);
			if (this._onStart !== void 0) return this._onStart;
			const [promise, resolve, reject] = this.createOnStartPromise();
			this._onStart = promise;
			this._diagnostics = void 0;
			for (const [method, handler] of this._notificationHandlers) if (!this._pendingNotificationHandlers.has(method)) this._pendingNotificationHandlers.set(method, handler);
			for (const [method, handler] of this._requestHandlers) if (!this._pendingRequestHandlers.has(method)) this._pendingRequestHandlers.set(method, handler);
			for (const [token, data] of this._progressHandlers) if (!this._pendingProgressHandlers.has(token)) this._pendingProgressHandlers.set(token, data);
			this.$state = ClientState.Starting;
			try {
				const connection = await this.createConnection();
				connection.onNotification(vscode_languageserver_protocol_1.LogMessageNotification.type, (message) => {
					switch (message.type) {
						case vscode_languageserver_protocol_1.MessageType.Error:
							this.error(message.message, void 0, false);
							break;
						case vscode_languageserver_protocol_1.MessageType.Warning:
							this.warn(message.message, void 0, false);
							break;
						case vscode_languageserver_protocol_1.MessageType.Info:
							this.info(message.message, void 0, false);
							break;
						case vscode_languageserver_protocol_1.MessageType.Debug:
							this.debug(message.message, void 0, false);
							break;
						default: this.outputChannel.appendLine(message.message);
					}
				});
				connection.onNotification(vscode_languageserver_protocol_1.ShowMessageNotification.type, (message) => {
					switch (message.type) {
						case vscode_languageserver_protocol_1.MessageType.Error:
							vscode_1.window.showErrorMessage(message.message);
							break;
						case vscode_languageserver_protocol_1.MessageType.Warning:
							vscode_1.window.showWarningMessage(message.message);
							break;
						case vscode_languageserver_protocol_1.MessageType.Info:
							vscode_1.window.showInformationMessage(message.message);
							break;
						default: vscode_1.window.showInformationMessage(message.message);
					}
				});
				connection.onRequest(vscode_languageserver_protocol_1.ShowMessageRequest.type, (params) => {
					let messageFunc;
					switch (params.type) {
						case vscode_languageserver_protocol_1.MessageType.Error:
							messageFunc = vscode_1.window.showErrorMessage;
							break;
						case vscode_languageserver_protocol_1.MessageType.Warning:
							messageFunc = vscode_1.window.showWarningMessage;
							break;
						case vscode_languageserver_protocol_1.MessageType.Info:
							messageFunc = vscode_1.window.showInformationMessage;
							break;
						default: messageFunc = vscode_1.window.showInformationMessage;
					}
					const actions = params.actions || [];
					return messageFunc(params.message, ...actions);
				});
				connection.onNotification(vscode_languageserver_protocol_1.TelemetryEventNotification.type, (data) => {
					this._telemetryEmitter.fire(data);
				});
				connection.onRequest(vscode_languageserver_protocol_1.ShowDocumentRequest.type, async (params, token) => {
					const showDocument = async (params) => {
						const uri = this.protocol2CodeConverter.asUri(params.uri);
						try {
							if (params.external === true) return { success: await vscode_1.env.openExternal(uri) };
							else {
								const options = {};
								if (params.selection !== void 0) options.selection = this.protocol2CodeConverter.asRange(params.selection);
								if (params.takeFocus === void 0 || params.takeFocus === false) options.preserveFocus = true;
								else if (params.takeFocus === true) options.preserveFocus = false;
								await vscode_1.window.showTextDocument(uri, options);
								return { success: true };
							}
						} catch (error) {
							return { success: false };
						}
					};
					const middleware = this._clientOptions.middleware.window?.showDocument;
					if (middleware !== void 0) return middleware(params, token, showDocument);
					else return showDocument(params);
				});
				connection.listen();
				await this.initialize(connection);
				resolve();
			} catch (error) {
				this.$state = ClientState.StartFailed;
				this.error(`${this._name} client: couldn't create connection to server.`, error, "force");
				reject(error);
			}
			return promise;
		}
		createOnStartPromise() {
			let resolve;
			let reject;
			return [
				new Promise((_resolve, _reject) => {
					resolve = _resolve;
					reject = _reject;
				}),
				resolve,
				reject
			];
		}
		async initialize(connection) {
			this.refreshTrace(connection, false);
			const initOption = this._clientOptions.initializationOptions;
			const [rootPath, workspaceFolders] = this._clientOptions.workspaceFolder !== void 0 ? [this._clientOptions.workspaceFolder.uri.fsPath, [{
				uri: this._c2p.asUri(this._clientOptions.workspaceFolder.uri),
				name: this._clientOptions.workspaceFolder.name
			}]] : [this._clientGetRootPath(), null];
			const initParams = {
				processId: null,
				clientInfo: {
					name: vscode_1.env.appName,
					version: vscode_1.version
				},
				locale: this.getLocale(),
				rootPath: rootPath ? rootPath : null,
				rootUri: rootPath ? this._c2p.asUri(vscode_1.Uri.file(rootPath)) : null,
				capabilities: this.computeClientCapabilities(),
				initializationOptions: Is.func(initOption) ? initOption() : initOption,
				trace: vscode_languageserver_protocol_1.Trace.toString(this._trace),
				workspaceFolders
			};
			this.fillInitializeParams(initParams);
			if (this._clientOptions.progressOnInitialization) {
				const token = (0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID();
				const part = new progressPart_1.ProgressPart(connection, token);
				initParams.workDoneToken = token;
				try {
					const result = await this.doInitialize(connection, initParams);
					part.done();
					return result;
				} catch (error) {
					part.cancel();
					throw error;
				}
			} else return this.doInitialize(connection, initParams);
		}
		async doInitialize(connection, initParams) {
			try {
				const result = await connection.initialize(initParams);
				if (result.capabilities.positionEncoding !== void 0 && result.capabilities.positionEncoding !== vscode_languageserver_protocol_1.PositionEncodingKind.UTF16) throw new Error(`Unsupported position encoding (${result.capabilities.positionEncoding}) received from server ${this.name}`);
				this._initializeResult = result;
				this.$state = ClientState.Running;
				let textDocumentSyncOptions = void 0;
				if (Is.number(result.capabilities.textDocumentSync)) {
					if (result.capabilities.textDocumentSync === vscode_languageserver_protocol_1.TextDocumentSyncKind.None) textDocumentSyncOptions = {
						openClose: false,
						change: vscode_languageserver_protocol_1.TextDocumentSyncKind.None,
						save: void 0
					};
					else textDocumentSyncOptions = {
						openClose: true,
						change: result.capabilities.textDocumentSync,
						save: { includeText: false }
					};
				} else if (result.capabilities.textDocumentSync !== void 0 && result.capabilities.textDocumentSync !== null) textDocumentSyncOptions = result.capabilities.textDocumentSync;
				this._capabilities = Object.assign({}, result.capabilities, { resolvedTextDocumentSync: textDocumentSyncOptions });
				connection.onNotification(vscode_languageserver_protocol_1.PublishDiagnosticsNotification.type, (params) => this.handleDiagnostics(params));
				connection.onRequest(vscode_languageserver_protocol_1.RegistrationRequest.type, (params) => this.handleRegistrationRequest(params));
				connection.onRequest("client/registerFeature", (params) => this.handleRegistrationRequest(params));
				connection.onRequest(vscode_languageserver_protocol_1.UnregistrationRequest.type, (params) => this.handleUnregistrationRequest(params));
				connection.onRequest("client/unregisterFeature", (params) => this.handleUnregistrationRequest(params));
				connection.onRequest(vscode_languageserver_protocol_1.ApplyWorkspaceEditRequest.type, (params) => this.handleApplyWorkspaceEdit(params));
				for (const [method, handler] of this._pendingNotificationHandlers) this._notificationDisposables.set(method, connection.onNotification(method, handler));
				this._pendingNotificationHandlers.clear();
				for (const [method, handler] of this._pendingRequestHandlers) this._requestDisposables.set(method, connection.onRequest(method, handler));
				this._pendingRequestHandlers.clear();
				for (const [token, data] of this._pendingProgressHandlers) this._progressDisposables.set(token, connection.onProgress(data.type, token, data.handler));
				this._pendingProgressHandlers.clear();
				await connection.sendNotification(vscode_languageserver_protocol_1.InitializedNotification.type, {});
				this.hookFileEvents(connection);
				this.hookLogLevelChanged(connection);
				this.hookConfigurationChanged(connection);
				this.initializeFeatures(connection);
				return result;
			} catch (error) {
				if (this._clientOptions.initializationFailedHandler) {
					if (this._clientOptions.initializationFailedHandler(error)) this.initialize(connection);
					else this.stopAfterFailedInitialize();
				} else if (error instanceof vscode_languageserver_protocol_1.ResponseError && error.data && error.data.retry) vscode_1.window.showErrorMessage(error.message, {
					title: "Retry",
					id: "retry"
				}).then((item) => {
					if (item && item.id === "retry") this.initialize(connection);
					else this.stopAfterFailedInitialize();
				});
				else {
					if (error && error.message) vscode_1.window.showErrorMessage(error.message);
					this.error("Server initialization failed.", error);
					this.stopAfterFailedInitialize();
				}
				throw error;
			}
		}
		stopAfterFailedInitialize() {
			this.stop().catch((error) => {
				this.error(`Stopping server failed`, error, false);
			});
		}
		_clientGetRootPath() {
			const folders = vscode_1.workspace.workspaceFolders;
			if (!folders || folders.length === 0) return;
			const folder = folders[0];
			if (folder.uri.scheme === "file") return folder.uri.fsPath;
		}
		stop(timeout = 2e3) {
			return this.shutdown(ShutdownMode.Stop, timeout);
		}
		dispose(timeout = 2e3) {
			try {
				this._disposed = "disposing";
				return this.stop(timeout);
			} finally {
				this._disposed = "disposed";
			}
		}
		async shutdown(mode, timeout = 2e3) {
			if (this.$state === ClientState.Stopped || this.$state === ClientState.Initial) return;
			if (this.$state === ClientState.Stopping) {
				if (this._onStop !== void 0) return this._onStop;
				else throw new Error(`Client is stopping but no stop promise available.`);
			}
			const connection = this.activeConnection();
			if (connection === void 0 || this.$state !== ClientState.Running) throw new Error(`Client is not running and can't be stopped. It's current state is: ${this.$state}`);
			this._initializeResult = void 0;
			this.$state = ClientState.Stopping;
			this.cleanUp(mode);
			const tp = new Promise((c) => {
				(0, vscode_languageserver_protocol_1.RAL)().timer.setTimeout(c, timeout);
			});
			const shutdown = (async (connection) => {
				await connection.shutdown();
				await connection.exit();
				return connection;
			})(connection);
			return this._onStop = (async () => {
				try {
					let result;
					try {
						result = await Promise.race([tp, shutdown]);
					} catch (error) {
						this.error(`Stopping server failed`, error, false);
						throw error;
					}
					if (result !== void 0) {
						result.end();
						result.dispose();
					} else {
						this.error(`Stopping server timed out`, void 0, false);
						throw new Error(`Stopping the server timed out`);
					}
				} finally {
					this.$state = ClientState.Stopped;
					mode === ShutdownMode.Stop && this.cleanUpChannel();
					this._onStart = void 0;
					this._onStop = void 0;
					this._connection = void 0;
					this._ignoredRegistrations.clear();
				}
			})();
		}
		cleanUp(mode) {
			this._fileEvents = [];
			this._fileEventDelayer.cancel();
			const disposables = this._listeners.splice(0, this._listeners.length);
			for (const disposable of disposables) disposable.dispose();
			if (this._syncedDocuments) this._syncedDocuments.clear();
			for (const feature of Array.from(this._features.entries()).map((entry) => entry[1]).reverse()) feature.clear();
			if (mode === ShutdownMode.Stop || mode === ShutdownMode.Restart) {
				if (this._diagnostics === void 0) this._diagnostics = null;
				if (this._diagnostics !== null) {
					this._clientOptions.diagnosticCollectionProvider.dispose(this._diagnostics, features_1.DiagnosticCollectionSource.push);
					this._diagnostics = null;
				}
			}
			if (this._idleInterval !== void 0) {
				this._idleInterval.dispose();
				this._idleInterval = void 0;
			}
		}
		cleanUpChannel() {
			if (this._outputChannel !== void 0 && this._disposeOutputChannel) {
				this._outputChannel.dispose();
				this._outputChannel = void 0;
			}
		}
		notifyFileEvent(event) {
			const client = this;
			async function didChangeWatchedFile(event) {
				client._fileEvents.push(event);
				return client._fileEventDelayer.trigger(async () => {
					const fileEvents = client._fileEvents;
					client._fileEvents = [];
					try {
						await client.sendNotification(vscode_languageserver_protocol_1.DidChangeWatchedFilesNotification.type, { changes: fileEvents });
					} catch (error) {
						client._fileEvents.push(...fileEvents);
						throw error;
					}
				});
			}
			const workSpaceMiddleware = this.clientOptions.middleware?.workspace;
			(workSpaceMiddleware?.didChangeWatchedFile ? workSpaceMiddleware.didChangeWatchedFile(event, didChangeWatchedFile) : didChangeWatchedFile(event)).catch((error) => {
				client.error(`Notifying file events failed.`, error);
			});
		}
		async sendPendingFullTextDocumentChanges(connection) {
			return this._pendingChangeSemaphore.lock(async () => {
				try {
					const changes = this._didChangeTextDocumentFeature.getPendingDocumentChanges(this._inFlightOpenNotifications);
					if (changes.length === 0) return;
					for (const document of changes) {
						const params = this.code2ProtocolConverter.asChangeTextDocumentParams(document);
						this._didChangeTextDocumentFeature.aboutToSendNotification(document, vscode_languageserver_protocol_1.DidChangeTextDocumentNotification.type, params);
						await connection.sendNotification(vscode_languageserver_protocol_1.DidChangeTextDocumentNotification.type, params);
						this._didChangeTextDocumentFeature.notificationSent(document, vscode_languageserver_protocol_1.DidChangeTextDocumentNotification.type, params);
					}
				} catch (error) {
					this.error(`Sending pending changes failed`, error, false);
					throw error;
				}
			});
		}
		triggerPendingChangeDelivery() {
			this._pendingChangeDelayer.trigger(async () => {
				const connection = this.activeConnection();
				if (connection === void 0) {
					this.triggerPendingChangeDelivery();
					return;
				}
				await this.sendPendingFullTextDocumentChanges(connection);
			}).catch((error) => this.error(`Delivering pending changes failed`, error, false));
		}
		_diagnosticQueue = /* @__PURE__ */ new Map();
		_diagnosticQueueState = { state: "idle" };
		handleDiagnostics(params) {
			if (this._diagnostics === null) return;
			const key = params.uri;
			if (this._diagnosticQueueState.state === "busy" && this._diagnosticQueueState.document === key) this._diagnosticQueueState.tokenSource.cancel();
			this._diagnosticQueue.set(params.uri, params.diagnostics);
			this.triggerDiagnosticQueue();
		}
		triggerDiagnosticQueue() {
			(0, vscode_languageserver_protocol_1.RAL)().timer.setImmediate(() => {
				this.workDiagnosticQueue();
			});
		}
		workDiagnosticQueue() {
			if (this._diagnosticQueueState.state === "busy") return;
			const next = this._diagnosticQueue.entries().next();
			if (next.done === true) return;
			const [document, diagnostics] = next.value;
			this._diagnosticQueue.delete(document);
			const tokenSource = new vscode_1.CancellationTokenSource();
			this._diagnosticQueueState = {
				state: "busy",
				document,
				tokenSource
			};
			this._p2c.asDiagnostics(diagnostics, tokenSource.token).then((converted) => {
				if (!tokenSource.token.isCancellationRequested) {
					const uri = this._p2c.asUri(document);
					const middleware = this.clientOptions.middleware;
					if (middleware.handleDiagnostics) middleware.handleDiagnostics(uri, converted, (uri, diagnostics) => this.setDiagnostics(uri, diagnostics));
					else this.setDiagnostics(uri, converted);
				}
			}).catch((error) => {
				this.error(`Processing diagnostic queue failed.`, error);
			}).finally(() => {
				this._diagnosticQueueState = { state: "idle" };
				this.triggerDiagnosticQueue();
			});
		}
		setDiagnostics(uri, diagnostics) {
			if (this._diagnostics === null) return;
			const diagnosticsCollection = this.diagnostics;
			if (diagnosticsCollection !== void 0) diagnosticsCollection.set(uri, diagnostics);
		}
		getLocale() {
			return vscode_1.env.language;
		}
		async $start() {
			if (this.$state === ClientState.StartFailed) throw new Error(`Previous start failed. Can't restart server.`);
			await this.start();
			const connection = this.activeConnection();
			if (connection === void 0) throw new Error(`Starting server failed`);
			return connection;
		}
		async createConnection() {
			const errorHandler = (error, message, count) => {
				this.handleConnectionError(error, message, count).catch((error) => this.error(`Handling connection error failed`, error));
			};
			const closeHandler = () => {
				this.handleConnectionClosed().catch((error) => this.error(`Handling connection close failed`, error));
			};
			const transports = await this.createMessageTransports(this._clientOptions.stdioEncoding || "utf8");
			this._connection = createConnection(transports.reader, transports.writer, errorHandler, closeHandler, this, this._clientOptions.connectionOptions);
			return this._connection;
		}
		async handleConnectionClosed() {
			if (this.$state === ClientState.Stopped) return;
			try {
				if (this._connection !== void 0) this._connection.dispose();
			} catch (error) {}
			let handlerResult = { action: CloseAction.DoNotRestart };
			if (this.$state !== ClientState.Stopping) try {
				handlerResult = await this._clientOptions.errorHandler.closed();
			} catch (error) {}
			this._connection = void 0;
			const handled = this.$state === ClientState.Stopping || handlerResult.handled === true;
			if (handlerResult.action === CloseAction.DoNotRestart) {
				this.error(handlerResult.message ?? "Connection to server got closed. Server will not be restarted.", void 0, handled ? false : "force");
				this.cleanUp(ShutdownMode.Stop);
				if (this.$state === ClientState.Starting) this.$state = ClientState.StartFailed;
				else this.$state = ClientState.Stopped;
				this._onStop = Promise.resolve();
				this._onStart = void 0;
			} else if (handlerResult.action === CloseAction.Restart) {
				this.info(handlerResult.message ?? "Connection to server got closed. Server will restart.", void 0, !handlerResult.handled);
				this.cleanUp(ShutdownMode.Restart);
				this.$state = ClientState.Initial;
				this._onStop = Promise.resolve();
				this._onStart = void 0;
				this.start().catch((error) => this.error(`Restarting server failed`, error, "force"));
			}
		}
		async handleConnectionError(error, message, count) {
			const handlerResult = await this._clientOptions.errorHandler.error(error, message, count);
			if (handlerResult.action === ErrorAction.Shutdown) {
				this.error(handlerResult.message ?? `Client ${this._name}: connection to server is erroring.\n${error.message}\nShutting down server.`, void 0, handlerResult.handled === true ? false : "force");
				this.stop().catch((error) => {
					this.error(`Stopping server failed`, error, false);
				});
			} else this.error(handlerResult.message ?? `Client ${this._name}: connection to server is erroring.\n${error.message}`, void 0, handlerResult.handled === true ? false : "force");
		}
		hookConfigurationChanged(connection) {
			this._listeners.push(vscode_1.workspace.onDidChangeConfiguration(() => {
				this.refreshTrace(connection, true);
			}));
		}
		hookLogLevelChanged(connection) {
			this._listeners.push(this.traceOutputChannel.onDidChangeLogLevel((level) => {
				this._traceLogLevel = level;
				this.refreshTrace(connection, true);
			}));
		}
		refreshTrace(connection, sendNotification = false) {
			const config = vscode_1.workspace.getConfiguration(this._id);
			let trace = this._traceLogLevel !== vscode_1.LogLevel.Trace ? vscode_languageserver_protocol_1.Trace.Off : vscode_languageserver_protocol_1.Trace.Messages;
			let traceFormat = vscode_languageserver_protocol_1.TraceFormat.Text;
			if (config && trace !== vscode_languageserver_protocol_1.Trace.Off) {
				const traceConfig = config.get("trace.server", "messages");
				if (typeof traceConfig === "string") {
					trace = vscode_languageserver_protocol_1.Trace.fromString(traceConfig);
					if (trace === vscode_languageserver_protocol_1.Trace.Off) trace = vscode_languageserver_protocol_1.Trace.Messages;
				} else {
					trace = vscode_languageserver_protocol_1.Trace.fromString(config.get("trace.server.verbosity", "messages"));
					if (trace === vscode_languageserver_protocol_1.Trace.Off) trace = vscode_languageserver_protocol_1.Trace.Messages;
					traceFormat = vscode_languageserver_protocol_1.TraceFormat.fromString(config.get("trace.server.format", "text"));
				}
			}
			this._trace = trace;
			this._traceFormat = traceFormat;
			connection.trace(this._trace, this._tracer, {
				sendNotification,
				traceFormat: this._traceFormat
			}).catch((error) => {
				this.error(`Updating trace failed with error`, error, false);
			});
		}
		hookFileEvents(_connection) {
			const fileEvents = this._clientOptions.synchronize.fileEvents;
			if (!fileEvents) return;
			let watchers;
			if (Is.array(fileEvents)) watchers = fileEvents;
			else watchers = [fileEvents];
			if (!watchers) return;
			this._dynamicFeatures.get(vscode_languageserver_protocol_1.DidChangeWatchedFilesNotification.type.method).registerRaw((0, vscode_languageserver_protocol_1.RAL)().crypto.randomUUID(), watchers);
		}
		_features = [];
		_dynamicFeatures = /* @__PURE__ */ new Map();
		registerFeatures(features) {
			for (const feature of features) this.registerFeature(feature);
		}
		registerFeature(feature) {
			this._features.push(feature);
			if (features_1.DynamicFeature.is(feature)) {
				const registrationType = feature.registrationType;
				this._dynamicFeatures.set(registrationType.method, feature);
			}
		}
		getFeature(request) {
			return this._dynamicFeatures.get(request);
		}
		hasDedicatedTextSynchronizationFeature(textDocument) {
			const feature = this.getFeature(vscode_languageserver_protocol_1.NotebookDocumentSyncRegistrationType.method);
			if (feature === void 0 || !(feature instanceof notebook_1.NotebookDocumentSyncFeature)) return false;
			return feature.handles(textDocument);
		}
		registerBuiltinFeatures() {
			const pendingFullTextDocumentChanges = /* @__PURE__ */ new Map();
			this.registerFeature(new configuration_1.ConfigurationFeature(this));
			this._didOpenTextDocumentFeature = new textSynchronization_1.DidOpenTextDocumentFeature(this, this._syncedDocuments);
			this.registerFeature(this._didOpenTextDocumentFeature);
			this._didChangeTextDocumentFeature = new textSynchronization_1.DidChangeTextDocumentFeature(this, pendingFullTextDocumentChanges);
			this._didChangeTextDocumentFeature.onPendingChangeAdded(() => {
				this.triggerPendingChangeDelivery();
			});
			this.registerFeature(this._didChangeTextDocumentFeature);
			this.registerFeature(new textSynchronization_1.WillSaveFeature(this));
			this.registerFeature(new textSynchronization_1.WillSaveWaitUntilFeature(this));
			this.registerFeature(new textSynchronization_1.DidSaveTextDocumentFeature(this));
			this.registerFeature(new textSynchronization_1.DidCloseTextDocumentFeature(this, this._syncedDocuments, pendingFullTextDocumentChanges));
			this.registerFeature(new fileSystemWatcher_1.FileSystemWatcherFeature(this, (event) => this.notifyFileEvent(event)));
			this.registerFeature(new completion_1.CompletionItemFeature(this));
			this.registerFeature(new hover_1.HoverFeature(this));
			this.registerFeature(new signatureHelp_1.SignatureHelpFeature(this));
			this.registerFeature(new definition_1.DefinitionFeature(this));
			this.registerFeature(new reference_1.ReferencesFeature(this));
			this.registerFeature(new documentHighlight_1.DocumentHighlightFeature(this));
			this.registerFeature(new documentSymbol_1.DocumentSymbolFeature(this));
			this.registerFeature(new workspaceSymbol_1.WorkspaceSymbolFeature(this));
			this.registerFeature(new codeAction_1.CodeActionFeature(this));
			this.registerFeature(new codeLens_1.CodeLensFeature(this));
			this.registerFeature(new formatting_1.DocumentFormattingFeature(this));
			this.registerFeature(new formatting_1.DocumentRangeFormattingFeature(this));
			this.registerFeature(new formatting_1.DocumentOnTypeFormattingFeature(this));
			this.registerFeature(new rename_1.RenameFeature(this));
			this.registerFeature(new documentLink_1.DocumentLinkFeature(this));
			this.registerFeature(new executeCommand_1.ExecuteCommandFeature(this));
			this.registerFeature(new configuration_1.SyncConfigurationFeature(this));
			this.registerFeature(new typeDefinition_1.TypeDefinitionFeature(this));
			this.registerFeature(new implementation_1.ImplementationFeature(this));
			this.registerFeature(new colorProvider_1.ColorProviderFeature(this));
			if (this.clientOptions.workspaceFolder === void 0) this.registerFeature(new workspaceFolder_1.WorkspaceFoldersFeature(this));
			this.registerFeature(new foldingRange_1.FoldingRangeFeature(this));
			this.registerFeature(new declaration_1.DeclarationFeature(this));
			this.registerFeature(new selectionRange_1.SelectionRangeFeature(this));
			this.registerFeature(new progress_1.ProgressFeature(this));
			this.registerFeature(new callHierarchy_1.CallHierarchyFeature(this));
			this.registerFeature(new semanticTokens_1.SemanticTokensFeature(this));
			this.registerFeature(new linkedEditingRange_1.LinkedEditingFeature(this));
			this.registerFeature(new fileOperations_1.DidCreateFilesFeature(this));
			this.registerFeature(new fileOperations_1.DidRenameFilesFeature(this));
			this.registerFeature(new fileOperations_1.DidDeleteFilesFeature(this));
			this.registerFeature(new fileOperations_1.WillCreateFilesFeature(this));
			this.registerFeature(new fileOperations_1.WillRenameFilesFeature(this));
			this.registerFeature(new fileOperations_1.WillDeleteFilesFeature(this));
			this.registerFeature(new typeHierarchy_1.TypeHierarchyFeature(this));
			this.registerFeature(new inlineValue_1.InlineValueFeature(this));
			this.registerFeature(new inlayHint_1.InlayHintsFeature(this));
			this.registerFeature(new diagnostic_1.DiagnosticFeature(this));
			this.registerFeature(new notebook_1.NotebookDocumentSyncFeature(this));
			this.registerFeature(new inlineCompletion_1.InlineCompletionItemFeature(this));
			this.registerFeature(new textDocumentContent_1.TextDocumentContentFeature(this));
		}
		registerProposedFeatures() {
			this.registerFeatures(ProposedFeatures.createAll(this));
		}
		fillInitializeParams(params) {
			for (const feature of this._features) if (Is.func(feature.fillInitializeParams)) feature.fillInitializeParams(params);
		}
		computeClientCapabilities() {
			const result = {};
			(0, features_1.ensure)(result, "workspace").applyEdit = true;
			const workspaceEdit = (0, features_1.ensure)((0, features_1.ensure)(result, "workspace"), "workspaceEdit");
			workspaceEdit.documentChanges = true;
			workspaceEdit.resourceOperations = [
				vscode_languageserver_protocol_1.ResourceOperationKind.Create,
				vscode_languageserver_protocol_1.ResourceOperationKind.Rename,
				vscode_languageserver_protocol_1.ResourceOperationKind.Delete
			];
			workspaceEdit.failureHandling = vscode_languageserver_protocol_1.FailureHandlingKind.TextOnlyTransactional;
			workspaceEdit.normalizesLineEndings = true;
			workspaceEdit.changeAnnotationSupport = { groupsOnLabel: true };
			workspaceEdit.metadataSupport = true;
			workspaceEdit.snippetEditSupport = true;
			const diagnostics = (0, features_1.ensure)((0, features_1.ensure)(result, "textDocument"), "publishDiagnostics");
			diagnostics.relatedInformation = true;
			diagnostics.versionSupport = false;
			diagnostics.tagSupport = { valueSet: [vscode_languageserver_protocol_1.DiagnosticTag.Unnecessary, vscode_languageserver_protocol_1.DiagnosticTag.Deprecated] };
			diagnostics.codeDescriptionSupport = true;
			diagnostics.dataSupport = true;
			const textDocumentFilter = (0, features_1.ensure)((0, features_1.ensure)(result, "textDocument"), "filters");
			textDocumentFilter.relativePatternSupport = true;
			const windowCapabilities = (0, features_1.ensure)(result, "window");
			const showMessage = (0, features_1.ensure)(windowCapabilities, "showMessage");
			showMessage.messageActionItem = { additionalPropertiesSupport: true };
			const showDocument = (0, features_1.ensure)(windowCapabilities, "showDocument");
			showDocument.support = true;
			const generalCapabilities = (0, features_1.ensure)(result, "general");
			generalCapabilities.staleRequestSupport = {
				cancel: true,
				retryOnContentModified: Array.from(BaseLanguageClient.RequestsToCancelOnContentModified)
			};
			generalCapabilities.regularExpressions = {
				engine: "ECMAScript",
				version: "ES2020"
			};
			generalCapabilities.markdown = {
				parser: "marked",
				version: "1.1.0"
			};
			generalCapabilities.positionEncodings = ["utf-16"];
			if (this._clientOptions.markdown.supportHtml) generalCapabilities.markdown.allowedTags = [
				"ul",
				"li",
				"p",
				"code",
				"blockquote",
				"ol",
				"h1",
				"h2",
				"h3",
				"h4",
				"h5",
				"h6",
				"hr",
				"em",
				"pre",
				"table",
				"thead",
				"tbody",
				"tr",
				"th",
				"td",
				"div",
				"del",
				"a",
				"strong",
				"br",
				"img",
				"span"
			];
			for (const feature of this._features) feature.fillClientCapabilities(result);
			return result;
		}
		initializeFeatures(_connection) {
			const documentSelector = this._clientOptions.documentSelector;
			for (const feature of this._features) if (Is.func(feature.preInitialize)) feature.preInitialize(this._capabilities, documentSelector);
			for (const feature of this._features) feature.initialize(this._capabilities, documentSelector);
		}
		async handleRegistrationRequest(params) {
			const middleware = this.clientOptions.middleware?.handleRegisterCapability;
			if (middleware) return middleware(params, (nextParams) => this.doRegisterCapability(nextParams));
			else return this.doRegisterCapability(params);
		}
		async doRegisterCapability(params) {
			if (!this.isRunning()) {
				for (const registration of params.registrations) this._ignoredRegistrations.add(registration.id);
				return;
			}
			for (const registration of params.registrations) {
				const feature = this._dynamicFeatures.get(registration.method);
				if (feature === void 0) return Promise.reject(/* @__PURE__ */ new Error(`No feature implementation for ${registration.method} found. Registration failed.`));
				const options = registration.registerOptions ?? {};
				options.documentSelector = options.documentSelector ?? this._clientOptions.documentSelector;
				const data = {
					id: registration.id,
					registerOptions: options
				};
				try {
					feature.register(data);
				} catch (err) {
					return Promise.reject(err);
				}
			}
		}
		async handleUnregistrationRequest(params) {
			const middleware = this.clientOptions.middleware?.handleUnregisterCapability;
			if (middleware) return middleware(params, (nextParams) => this.doUnregisterCapability(nextParams));
			else return this.doUnregisterCapability(params);
		}
		async doUnregisterCapability(params) {
			for (const unregistration of params.unregisterations) {
				if (this._ignoredRegistrations.has(unregistration.id)) continue;
				const feature = this._dynamicFeatures.get(unregistration.method);
				if (!feature) return Promise.reject(/* @__PURE__ */ new Error(`No feature implementation for ${unregistration.method} found. Unregistration failed.`));
				feature.unregister(unregistration.id);
			}
		}
		async handleApplyWorkspaceEdit(params) {
			const middleware = this.clientOptions.middleware?.workspace?.handleApplyEdit;
			if (middleware) {
				const resultOrError = await middleware(params, (nextParams) => this.doHandleApplyWorkspaceEdit(nextParams));
				if (resultOrError instanceof vscode_languageserver_protocol_1.ResponseError) return Promise.reject(resultOrError);
				return resultOrError;
			} else return this.doHandleApplyWorkspaceEdit(params);
		}
		workspaceEditLock = new async_1.Semaphore(1);
		async doHandleApplyWorkspaceEdit(params) {
			const workspaceEdit = params.edit;
			const converted = await this.workspaceEditLock.lock(() => {
				return this._p2c.asWorkspaceEdit(workspaceEdit);
			});
			if (!this.validateWorkspaceEdit(workspaceEdit)) return Promise.resolve({ applied: false });
			return Is.asPromise(vscode_1.workspace.applyEdit(converted, { isRefactoring: params.metadata?.isRefactoring }).then((value) => {
				return { applied: value };
			}));
		}
		validateWorkspaceEdit(workspaceEdit) {
			const openTextDocuments = /* @__PURE__ */ new Map();
			vscode_1.workspace.textDocuments.forEach((document) => openTextDocuments.set(document.uri.toString(), document));
			if (workspaceEdit.documentChanges) {
				for (const change of workspaceEdit.documentChanges) if (vscode_languageserver_protocol_1.TextDocumentEdit.is(change) && change.textDocument.version !== null && change.textDocument.version >= 0) {
					const changeUri = this._p2c.asUri(change.textDocument.uri).toString();
					const textDocument = openTextDocuments.get(changeUri);
					if (textDocument && textDocument.version !== change.textDocument.version) return false;
				}
			}
			return true;
		}
		static RequestsToCancelOnContentModified = /* @__PURE__ */ new Set([
			vscode_languageserver_protocol_1.SemanticTokensRequest.method,
			vscode_languageserver_protocol_1.SemanticTokensRangeRequest.method,
			vscode_languageserver_protocol_1.SemanticTokensDeltaRequest.method
		]);
		static CancellableResolveCalls = /* @__PURE__ */ new Set([
			vscode_languageserver_protocol_1.CompletionResolveRequest.method,
			vscode_languageserver_protocol_1.CodeLensResolveRequest.method,
			vscode_languageserver_protocol_1.CodeActionResolveRequest.method,
			vscode_languageserver_protocol_1.InlayHintResolveRequest.method,
			vscode_languageserver_protocol_1.DocumentLinkResolveRequest.method,
			vscode_languageserver_protocol_1.WorkspaceSymbolResolveRequest.method
		]);
		handleFailedRequest(type, token, error, defaultValue, showNotification = true, throwOnCancel = false) {
			if (error instanceof vscode_languageserver_protocol_1.ResponseError) {
				if (error.code === vscode_languageserver_protocol_1.ErrorCodes.PendingResponseRejected || error.code === vscode_languageserver_protocol_1.ErrorCodes.ConnectionInactive) return defaultValue;
				if (error.code === vscode_languageserver_protocol_1.LSPErrorCodes.RequestCancelled || error.code === vscode_languageserver_protocol_1.LSPErrorCodes.ServerCancelled) {
					if (token !== void 0 && token.isCancellationRequested && !throwOnCancel) return defaultValue;
					else if (error.data !== void 0) throw new features_1.LSPCancellationError(error.data);
					else throw new vscode_1.CancellationError();
				} else if (error.code === vscode_languageserver_protocol_1.LSPErrorCodes.ContentModified) {
					if (BaseLanguageClient.RequestsToCancelOnContentModified.has(type.method) || BaseLanguageClient.CancellableResolveCalls.has(type.method)) throw new vscode_1.CancellationError();
					else return defaultValue;
				}
			}
			this.error(`Request ${type.method} failed.`, error, showNotification);
			throw error;
		}
	};
	exports.BaseLanguageClient = BaseLanguageClient;
	var LanguageClient = class extends BaseLanguageClient {
		serverOptions;
		constructor(id, name, serverOptions, clientOptions) {
			super(id, name, clientOptions);
			this.serverOptions = serverOptions;
		}
		async createMessageTransports(_encoding) {
			return this.serverOptions();
		}
	};
	exports.LanguageClient = LanguageClient;
	var ConsoleLogger = class {
		error(message) {
			(0, vscode_languageserver_protocol_1.RAL)().console.error(message);
		}
		warn(message) {
			(0, vscode_languageserver_protocol_1.RAL)().console.warn(message);
		}
		info(message) {
			(0, vscode_languageserver_protocol_1.RAL)().console.info(message);
		}
		log(message) {
			(0, vscode_languageserver_protocol_1.RAL)().console.log(message);
		}
	};
	var OutputChannelLogger = class {
		channelProvider;
		constructor(channelProvider) {
			this.channelProvider = channelProvider;
		}
		error(message) {
			this.channelProvider.error(message, void 0, false);
		}
		warn(message) {
			this.channelProvider.warn(message, void 0, false);
		}
		info(message) {
			this.channelProvider.info(message, void 0, false);
		}
		log(message) {
			this.channelProvider.info(message, void 0, false);
		}
	};
	function createConnection(input, output, errorHandler, closeHandler, channelProvider, options) {
		const logger = channelProvider !== void 0 ? new OutputChannelLogger(channelProvider) : new ConsoleLogger();
		const connection = (0, vscode_languageserver_protocol_1.createProtocolConnection)(input, output, logger, options);
		connection.onError((data) => {
			errorHandler(data[0], data[1], data[2]);
		});
		connection.onClose(closeHandler);
		return {
			listen: () => connection.listen(),
			sendRequest: connection.sendRequest,
			onRequest: connection.onRequest,
			hasPendingResponse: connection.hasPendingResponse,
			sendNotification: connection.sendNotification,
			onNotification: connection.onNotification,
			onProgress: connection.onProgress,
			sendProgress: connection.sendProgress,
			trace: (value, tracer, sendNotificationOrTraceOptions) => {
				const defaultTraceOptions = {
					sendNotification: false,
					traceFormat: vscode_languageserver_protocol_1.TraceFormat.Text
				};
				if (sendNotificationOrTraceOptions === void 0) return connection.trace(value, tracer, defaultTraceOptions);
				else if (Is.boolean(sendNotificationOrTraceOptions)) return connection.trace(value, tracer, sendNotificationOrTraceOptions);
				else return connection.trace(value, tracer, sendNotificationOrTraceOptions);
			},
			initialize: (params) => {
				return connection.sendRequest(vscode_languageserver_protocol_1.InitializeRequest.type, params);
			},
			shutdown: () => {
				return connection.sendRequest(vscode_languageserver_protocol_1.ShutdownRequest.type, void 0);
			},
			exit: () => {
				return connection.sendNotification(vscode_languageserver_protocol_1.ExitNotification.type);
			},
			end: () => connection.end(),
			dispose: () => connection.dispose()
		};
	}
	var ProposedFeatures;
	(function(ProposedFeatures) {
		function createAll(_client) {
			return [];
		}
		ProposedFeatures.createAll = createAll;
	})(ProposedFeatures || (exports.ProposedFeatures = ProposedFeatures = {}));
}));
// node_modules/vscode-languageclient/lib/node/processes.js
var require_processes = /* @__PURE__ */ __commonJSMin(((exports, module, this$5) => {
	var __createBinding = this$5 && this$5.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$5 && this$5.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$5 && this$5.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.terminate = terminate;
	var cp = __importStar(require("child_process"));
	var isWindows = process.platform === "win32";
	var isMacintosh = process.platform === "darwin";
	var isLinux = process.platform === "linux";
	function terminate(process, cwd) {
		if (isWindows) try {
			const options = { stdio: [
				"pipe",
				"pipe",
				"ignore"
			] };
			if (cwd) options.cwd = cwd;
			cp.execFileSync("taskkill", [
				"/T",
				"/F",
				"/PID",
				process.pid.toString()
			], options);
			return true;
		} catch (err) {
			return false;
		}
		else if (isLinux || isMacintosh) try {
			const pid = process.pid.toString();
			if (!/^\d+$/.test(pid)) return false;
			const script = `
terminateTree() {
	for cpid in $(pgrep -P "$1"); do
		terminateTree "$cpid"
	done
	kill -9 "$1" > /dev/null 2>&1
}

terminateTree "${pid}"
`;
			return cp.spawnSync("/bin/sh", [], {
				input: script,
				stdio: [
					"pipe",
					"inherit",
					"inherit"
				]
			}).error ? false : true;
		} catch (err) {
			return false;
		}
		else {
			process.kill("SIGKILL");
			return true;
		}
	}
}));
// node_modules/vscode-jsonrpc/lib/node/ril.js
var require_ril = /* @__PURE__ */ __commonJSMin(((exports) => {
	Object.defineProperty(exports, "__esModule", { value: true });
	var util_1 = require("util");
	var crypto_1 = require("crypto");
	var api_1 = require_api$2();
	var MessageBuffer = class MessageBuffer extends api_1.AbstractMessageBuffer {
		static emptyBuffer = Buffer.allocUnsafe(0);
		constructor(encoding = "utf-8") {
			super(encoding);
		}
		emptyBuffer() {
			return MessageBuffer.emptyBuffer;
		}
		fromString(value, encoding) {
			return Buffer.from(value, encoding);
		}
		toString(value, encoding) {
			if (value instanceof Buffer) return value.toString(encoding);
			else return new util_1.TextDecoder(encoding).decode(value);
		}
		asNative(buffer, length) {
			if (length === void 0) return buffer instanceof Buffer ? buffer : Buffer.from(buffer);
			else return buffer instanceof Buffer ? buffer.slice(0, length) : Buffer.from(buffer.subarray(0, length));
		}
		allocNative(length) {
			return Buffer.allocUnsafe(length);
		}
	};
	var ReadableStreamWrapper = class {
		stream;
		constructor(stream) {
			this.stream = stream;
		}
		onClose(listener) {
			this.stream.on("close", listener);
			return api_1.Disposable.create(() => this.stream.off("close", listener));
		}
		onError(listener) {
			this.stream.on("error", listener);
			return api_1.Disposable.create(() => this.stream.off("error", listener));
		}
		onEnd(listener) {
			this.stream.on("end", listener);
			return api_1.Disposable.create(() => this.stream.off("end", listener));
		}
		onData(listener) {
			this.stream.on("data", listener);
			return api_1.Disposable.create(() => this.stream.off("data", listener));
		}
	};
	var WritableStreamWrapper = class {
		stream;
		constructor(stream) {
			this.stream = stream;
		}
		onClose(listener) {
			this.stream.on("close", listener);
			return api_1.Disposable.create(() => this.stream.off("close", listener));
		}
		onError(listener) {
			this.stream.on("error", listener);
			return api_1.Disposable.create(() => this.stream.off("error", listener));
		}
		onEnd(listener) {
			this.stream.on("end", listener);
			return api_1.Disposable.create(() => this.stream.off("end", listener));
		}
		write(data, encoding) {
			return new Promise((resolve, reject) => {
				const callback = (error) => {
					if (error === void 0 || error === null) resolve();
					else reject(error);
				};
				if (typeof data === "string") this.stream.write(data, encoding, callback);
				else this.stream.write(data, callback);
			});
		}
		end() {
			this.stream.end();
		}
	};
	var _ril = Object.freeze({
		crypto: Object.freeze({ randomUUID: () => (0, crypto_1.randomUUID)() }),
		messageBuffer: Object.freeze({ create: (encoding) => new MessageBuffer(encoding) }),
		applicationJson: Object.freeze({
			encoder: Object.freeze({
				name: "application/json",
				encode: (msg, options) => {
					try {
						return Promise.resolve(Buffer.from(JSON.stringify(msg, void 0, 0), options.charset));
					} catch (err) {
						return Promise.reject(err);
					}
				}
			}),
			decoder: Object.freeze({
				name: "application/json",
				decode: (buffer, options) => {
					try {
						if (buffer instanceof Buffer) return Promise.resolve(JSON.parse(buffer.toString(options.charset)));
						else return Promise.resolve(JSON.parse(new util_1.TextDecoder(options.charset).decode(buffer)));
					} catch (err) {
						return Promise.reject(err);
					}
				}
			})
		}),
		stream: Object.freeze({
			asReadableStream: (stream) => new ReadableStreamWrapper(stream),
			asWritableStream: (stream) => new WritableStreamWrapper(stream)
		}),
		console,
		timer: Object.freeze({
			setTimeout(callback, ms, ...args) {
				const handle = setTimeout(callback, ms, ...args);
				return { dispose: () => clearTimeout(handle) };
			},
			setImmediate(callback, ...args) {
				const handle = setImmediate(callback, ...args);
				return { dispose: () => clearImmediate(handle) };
			},
			setInterval(callback, ms, ...args) {
				const handle = setInterval(callback, ms, ...args);
				return { dispose: () => clearInterval(handle) };
			}
		})
	});
	function RIL() {
		return _ril;
	}
	(function(RIL) {
		function install() {
			api_1.RAL.install(_ril);
		}
		RIL.install = install;
	})(RIL || (RIL = {}));
	exports.default = RIL;
}));
// node_modules/vscode-jsonrpc/lib/node/main.js
var require_main$2 = /* @__PURE__ */ __commonJSMin(((exports, module, this$4) => {
	var __createBinding = this$4 && this$4.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$4 && this$4.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$4 && this$4.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	var __exportStar = this$4 && this$4.__exportStar || function(m, exports) {
		for (var p in m) if (p !== "default" && !Object.prototype.hasOwnProperty.call(exports, p)) __createBinding(exports, m, p);
	};
	var __importDefault = this$4 && this$4.__importDefault || function(mod) {
		return mod && mod.__esModule ? mod : { "default": mod };
	};
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.StreamMessageWriter = exports.StreamMessageReader = exports.SocketMessageWriter = exports.SocketMessageReader = exports.PortMessageWriter = exports.PortMessageReader = exports.IPCMessageWriter = exports.IPCMessageReader = void 0;
	exports.generateRandomPipeName = generateRandomPipeName;
	exports.createClientPipeTransport = createClientPipeTransport;
	exports.createServerPipeTransport = createServerPipeTransport;
	exports.createClientSocketTransport = createClientSocketTransport;
	exports.createServerSocketTransport = createServerSocketTransport;
	exports.createMessageConnection = createMessageConnection;
	var ril_1 = __importDefault(require_ril());
	ril_1.default.install();
	var path = __importStar(require("path"));
	var os = __importStar(require("os"));
	var fs = __importStar(require("fs"));
	var crypto_1 = require("crypto");
	var net_1 = require("net");
	var api_1 = require_api$2();
	__exportStar(require_api$2(), exports);
	var IPCMessageReader = class extends api_1.AbstractMessageReader {
		process;
		constructor(process) {
			super();
			this.process = process;
			const eventEmitter = this.process;
			eventEmitter.on("error", (error) => this.fireError(error));
			eventEmitter.on("close", () => this.fireClose());
		}
		listen(callback) {
			this.process.on("message", callback);
			return api_1.Disposable.create(() => this.process.off("message", callback));
		}
	};
	exports.IPCMessageReader = IPCMessageReader;
	var IPCMessageWriter = class extends api_1.AbstractMessageWriter {
		process;
		errorCount;
		constructor(process) {
			super();
			this.process = process;
			this.errorCount = 0;
			const eventEmitter = this.process;
			eventEmitter.on("error", (error) => this.fireError(error));
			eventEmitter.on("close", () => this.fireClose());
		}
		write(msg) {
			try {
				if (typeof this.process.send === "function") this.process.send(msg, void 0, void 0, (error) => {
					if (error) {
						this.errorCount++;
						this.handleError(error, msg);
					} else this.errorCount = 0;
				});
				return Promise.resolve();
			} catch (error) {
				this.handleError(error, msg);
				return Promise.reject(error);
			}
		}
		handleError(error, msg) {
			this.errorCount++;
			this.fireError(error, msg, this.errorCount);
		}
		end() {}
	};
	exports.IPCMessageWriter = IPCMessageWriter;
	var PortMessageReader = class extends api_1.AbstractMessageReader {
		onData;
		constructor(port) {
			super();
			this.onData = new api_1.Emitter();
			port.on("close", () => this.fireClose());
			port.on("error", (error) => this.fireError(error));
			port.on("message", (message) => {
				this.onData.fire(message);
			});
		}
		listen(callback) {
			return this.onData.event(callback);
		}
	};
	exports.PortMessageReader = PortMessageReader;
	var PortMessageWriter = class extends api_1.AbstractMessageWriter {
		port;
		errorCount;
		constructor(port) {
			super();
			this.port = port;
			this.errorCount = 0;
			port.on("close", () => this.fireClose());
			port.on("error", (error) => this.fireError(error));
		}
		write(msg) {
			try {
				this.port.postMessage(msg);
				return Promise.resolve();
			} catch (error) {
				this.handleError(error, msg);
				return Promise.reject(error);
			}
		}
		handleError(error, msg) {
			this.errorCount++;
			this.fireError(error, msg, this.errorCount);
		}
		end() {}
	};
	exports.PortMessageWriter = PortMessageWriter;
	var SocketMessageReader = class extends api_1.ReadableStreamMessageReader {
		constructor(socket, encoding = "utf-8") {
			super((0, ril_1.default)().stream.asReadableStream(socket), encoding);
		}
	};
	exports.SocketMessageReader = SocketMessageReader;
	var SocketMessageWriter = class extends api_1.WriteableStreamMessageWriter {
		socket;
		constructor(socket, options) {
			super((0, ril_1.default)().stream.asWritableStream(socket), options);
			this.socket = socket;
		}
		dispose() {
			super.dispose();
			this.socket.destroy();
		}
	};
	exports.SocketMessageWriter = SocketMessageWriter;
	var StreamMessageReader = class extends api_1.ReadableStreamMessageReader {
		constructor(readable, encoding) {
			super((0, ril_1.default)().stream.asReadableStream(readable), encoding);
		}
	};
	exports.StreamMessageReader = StreamMessageReader;
	var StreamMessageWriter = class extends api_1.WriteableStreamMessageWriter {
		constructor(writable, options) {
			super((0, ril_1.default)().stream.asWritableStream(writable), options);
		}
	};
	exports.StreamMessageWriter = StreamMessageWriter;
	var XDG_RUNTIME_DIR = process.env["XDG_RUNTIME_DIR"];
	var safeIpcPathLengths = /* @__PURE__ */ new Map([["linux", 107], ["darwin", 102]]);
	function generateRandomPipeName() {
		if (process.platform === "win32") return `\\\\.\\pipe\\lsp-${(0, crypto_1.randomBytes)(16).toString("hex")}-sock`;
		let randomLength = 32;
		const fixedLength = 10;
		const tmpDir = fs.realpathSync(XDG_RUNTIME_DIR ?? os.tmpdir());
		const limit = safeIpcPathLengths.get(process.platform);
		if (limit !== void 0) randomLength = Math.min(limit - tmpDir.length - fixedLength, randomLength);
		if (randomLength < 16) throw new Error(`Unable to generate a random pipe name with ${randomLength} characters.`);
		const randomSuffix = (0, crypto_1.randomBytes)(Math.floor(randomLength / 2)).toString("hex");
		return path.join(tmpDir, `lsp-${randomSuffix}.sock`);
	}
	function createClientPipeTransport(pipeName, encoding = "utf-8") {
		let connectResolve;
		const connected = new Promise((resolve, _reject) => {
			connectResolve = resolve;
		});
		return new Promise((resolve, reject) => {
			const server = (0, net_1.createServer)((socket) => {
				server.close();
				connectResolve([new SocketMessageReader(socket, encoding), new SocketMessageWriter(socket, encoding)]);
			});
			server.on("error", reject);
			server.listen(pipeName, () => {
				server.removeListener("error", reject);
				resolve({
					onConnected: () => {
						return connected;
					},
					close: () => {
						server.close();
					}
				});
			});
		});
	}
	function createServerPipeTransport(pipeName, encoding = "utf-8") {
		const socket = (0, net_1.createConnection)(pipeName);
		return [new SocketMessageReader(socket, encoding), new SocketMessageWriter(socket, encoding)];
	}
	function createClientSocketTransport(port, encoding = "utf-8") {
		let connectResolve;
		const connected = new Promise((resolve, _reject) => {
			connectResolve = resolve;
		});
		return new Promise((resolve, reject) => {
			const server = (0, net_1.createServer)((socket) => {
				server.close();
				connectResolve([new SocketMessageReader(socket, encoding), new SocketMessageWriter(socket, encoding)]);
			});
			server.on("error", reject);
			server.listen(port, "127.0.0.1", () => {
				server.removeListener("error", reject);
				const address = server.address();
				if (address === null || typeof address === "string") {
					reject(/* @__PURE__ */ new Error(`Unexpected server address: ${address}`));
					return;
				}
				const boundPort = address.port;
				resolve({
					port: () => boundPort,
					onConnected: () => {
						return connected;
					},
					close: () => {
						server.close();
					}
				});
			});
		});
	}
	function createServerSocketTransport(port, encoding = "utf-8") {
		const socket = (0, net_1.createConnection)(port, "127.0.0.1");
		return [new SocketMessageReader(socket, encoding), new SocketMessageWriter(socket, encoding)];
	}
	function isReadableStream(value) {
		const candidate = value;
		return candidate.read !== void 0 && candidate.addListener !== void 0;
	}
	function isWritableStream(value) {
		const candidate = value;
		return candidate.write !== void 0 && candidate.addListener !== void 0;
	}
	function createMessageConnection(input, output, logger, options) {
		if (!logger) logger = api_1.NullLogger;
		const reader = isReadableStream(input) ? new StreamMessageReader(input) : input;
		const writer = isWritableStream(output) ? new StreamMessageWriter(output) : output;
		if (api_1.ConnectionStrategy.is(options)) options = { connectionStrategy: options };
		return (0, api_1.createMessageConnection)(reader, writer, logger, options);
	}
}));
// node_modules/vscode-languageserver-protocol/lib/node/main.js
var require_main$1 = /* @__PURE__ */ __commonJSMin(((exports, module, this$3) => {
	var __createBinding = this$3 && this$3.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __exportStar = this$3 && this$3.__exportStar || function(m, exports) {
		for (var p in m) if (p !== "default" && !Object.prototype.hasOwnProperty.call(exports, p)) __createBinding(exports, m, p);
	};
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.createProtocolConnection = createProtocolConnection;
	var node_1 = require_main$2();
	__exportStar(require_main$2(), exports);
	__exportStar(require_api$1(), exports);
	function createProtocolConnection(input, output, logger, options) {
		return (0, node_1.createMessageConnection)(input, output, logger, options);
	}
}));
// node_modules/semver/internal/debug.js
var require_debug = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	module.exports = typeof process === "object" && process.env && process.env.NODE_DEBUG && /\bsemver\b/i.test(process.env.NODE_DEBUG) ? (...args) => console.error("SEMVER", ...args) : () => {};
}));
// node_modules/semver/internal/constants.js
var require_constants = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	module.exports = {
		MAX_LENGTH: 256,
		MAX_SAFE_COMPONENT_LENGTH: 16,
		MAX_SAFE_BUILD_LENGTH: 250,
		MAX_SAFE_INTEGER: Number.MAX_SAFE_INTEGER || 
		/* istanbul ignore next */ 9007199254740991,
		WHITESPACE_CHARACTERS: [
			"	",
			"\n",
			"\v",
			"\f",
			"\r",
			" ",
			"\xA0",
			" ",
			" ",
			" ",
			" ",
			" ",
			" ",
			" ",
			" ",
			" ",
			" ",
			" ",
			" ",
			"\u2028",
			"\u2029",
			" ",
			" ",
			"　",
			"﻿"
		],
		RELEASE_TYPES: [
			"major",
			"premajor",
			"minor",
			"preminor",
			"patch",
			"prepatch",
			"prerelease"
		],
		SEMVER_SPEC_VERSION: "2.0.0",
		FLAG_INCLUDE_PRERELEASE: 1,
		FLAG_LOOSE: 2
	};
}));
// node_modules/semver/internal/re.js
var require_re = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	var { MAX_SAFE_COMPONENT_LENGTH, MAX_SAFE_BUILD_LENGTH, MAX_LENGTH } = require_constants();
	var debug = require_debug();
	exports = module.exports = {};
	var re = exports.re = [];
	var safeRe = exports.safeRe = [];
	var src = exports.src = [];
	var safeSrc = exports.safeSrc = [];
	var t = exports.t = {};
	var R = 0;
	var LETTERDASHNUMBER = "[a-zA-Z0-9-]";
	var safeRegexReplacements = [
		["\\s", 1],
		["\\d", MAX_LENGTH],
		[LETTERDASHNUMBER, MAX_SAFE_BUILD_LENGTH]
	];
	var makeSafeRegex = (value) => {
		for (const [token, max] of safeRegexReplacements) value = value.split(`${token}*`).join(`${token}{0,${max}}`).split(`${token}+`).join(`${token}{1,${max}}`);
		return value;
	};
	var createToken = (name, value, isGlobal) => {
		const safe = makeSafeRegex(value);
		const index = R++;
		debug(name, index, value);
		t[name] = index;
		src[index] = value;
		safeSrc[index] = safe;
		re[index] = new RegExp(value, isGlobal ? "g" : void 0);
		safeRe[index] = new RegExp(safe, isGlobal ? "g" : void 0);
	};
	createToken("NUMERICIDENTIFIER", "0|[1-9]\\d*");
	createToken("NUMERICIDENTIFIERLOOSE", "\\d+");
	createToken("NONNUMERICIDENTIFIER", `\\d*[a-zA-Z-]${LETTERDASHNUMBER}*`);
	createToken("MAINVERSION", `(${src[t.NUMERICIDENTIFIER]})\\.(${src[t.NUMERICIDENTIFIER]})\\.(${src[t.NUMERICIDENTIFIER]})`);
	createToken("MAINVERSIONLOOSE", `(${src[t.NUMERICIDENTIFIERLOOSE]})\\.(${src[t.NUMERICIDENTIFIERLOOSE]})\\.(${src[t.NUMERICIDENTIFIERLOOSE]})`);
	createToken("PRERELEASEIDENTIFIER", `(?:${src[t.NONNUMERICIDENTIFIER]}|${src[t.NUMERICIDENTIFIER]})`);
	createToken("PRERELEASEIDENTIFIERLOOSE", `(?:${src[t.NONNUMERICIDENTIFIER]}|${src[t.NUMERICIDENTIFIERLOOSE]})`);
	createToken("PRERELEASE", `(?:-(${src[t.PRERELEASEIDENTIFIER]}(?:\\.${src[t.PRERELEASEIDENTIFIER]})*))`);
	createToken("PRERELEASELOOSE", `(?:-?(${src[t.PRERELEASEIDENTIFIERLOOSE]}(?:\\.${src[t.PRERELEASEIDENTIFIERLOOSE]})*))`);
	createToken("BUILDIDENTIFIER", `${LETTERDASHNUMBER}+`);
	createToken("BUILD", `(?:\\+(${src[t.BUILDIDENTIFIER]}(?:\\.${src[t.BUILDIDENTIFIER]})*))`);
	createToken("FULLPLAIN", `v?${src[t.MAINVERSION]}${src[t.PRERELEASE]}?${src[t.BUILD]}?`);
	createToken("FULL", `^${src[t.FULLPLAIN]}$`);
	createToken("LOOSEPLAIN", `[v=\\s]*${src[t.MAINVERSIONLOOSE]}${src[t.PRERELEASELOOSE]}?${src[t.BUILD]}?`);
	createToken("LOOSE", `^${src[t.LOOSEPLAIN]}$`);
	createToken("GTLT", "((?:<|>)?=?)");
	createToken("XRANGEIDENTIFIERLOOSE", `${src[t.NUMERICIDENTIFIERLOOSE]}|x|X|\\*`);
	createToken("XRANGEIDENTIFIER", `${src[t.NUMERICIDENTIFIER]}|x|X|\\*`);
	createToken("XRANGEPLAIN", `[v=\\s]*(${src[t.XRANGEIDENTIFIER]})(?:\\.(${src[t.XRANGEIDENTIFIER]})(?:\\.(${src[t.XRANGEIDENTIFIER]})(?:${src[t.PRERELEASE]})?${src[t.BUILD]}?)?)?`);
	createToken("XRANGEPLAINLOOSE", `[v=\\s]*(${src[t.XRANGEIDENTIFIERLOOSE]})(?:\\.(${src[t.XRANGEIDENTIFIERLOOSE]})(?:\\.(${src[t.XRANGEIDENTIFIERLOOSE]})(?:${src[t.PRERELEASELOOSE]})?${src[t.BUILD]}?)?)?`);
	createToken("XRANGE", `^${src[t.GTLT]}\\s*${src[t.XRANGEPLAIN]}$`);
	createToken("XRANGELOOSE", `^${src[t.GTLT]}\\s*${src[t.XRANGEPLAINLOOSE]}$`);
	createToken("COERCEPLAIN", `(^|[^\\d])(\\d{1,${MAX_SAFE_COMPONENT_LENGTH}})(?:\\.(\\d{1,${MAX_SAFE_COMPONENT_LENGTH}}))?(?:\\.(\\d{1,${MAX_SAFE_COMPONENT_LENGTH}}))?`);
	createToken("COERCE", `${src[t.COERCEPLAIN]}(?:$|[^\\d])`);
	createToken("COERCEFULL", src[t.COERCEPLAIN] + `(?:${src[t.PRERELEASE]})?(?:${src[t.BUILD]})?(?:$|[^\\d])`);
	createToken("COERCERTL", src[t.COERCE], true);
	createToken("COERCERTLFULL", src[t.COERCEFULL], true);
	createToken("LONETILDE", "(?:~>?)");
	createToken("TILDETRIM", `(\\s*)${src[t.LONETILDE]}\\s+`, true);
	exports.tildeTrimReplace = "$1~";
	createToken("TILDE", `^${src[t.LONETILDE]}${src[t.XRANGEPLAIN]}$`);
	createToken("TILDELOOSE", `^${src[t.LONETILDE]}${src[t.XRANGEPLAINLOOSE]}$`);
	createToken("LONECARET", "(?:\\^)");
	createToken("CARETTRIM", `(\\s*)${src[t.LONECARET]}\\s+`, true);
	exports.caretTrimReplace = "$1^";
	createToken("CARET", `^${src[t.LONECARET]}${src[t.XRANGEPLAIN]}$`);
	createToken("CARETLOOSE", `^${src[t.LONECARET]}${src[t.XRANGEPLAINLOOSE]}$`);
	createToken("COMPARATORLOOSE", `^${src[t.GTLT]}\\s*(${src[t.LOOSEPLAIN]})$|^$`);
	createToken("COMPARATOR", `^${src[t.GTLT]}\\s*(${src[t.FULLPLAIN]})$|^$`);
	createToken("COMPARATORTRIM", `(\\s*)${src[t.GTLT]}\\s*(${src[t.LOOSEPLAIN]}|${src[t.XRANGEPLAIN]})`, true);
	exports.comparatorTrimReplace = "$1$2$3";
	createToken("HYPHENRANGE", `^\\s*(${src[t.XRANGEPLAIN]})\\s+-\\s+(${src[t.XRANGEPLAIN]})\\s*$`);
	createToken("HYPHENRANGELOOSE", `^\\s*(${src[t.XRANGEPLAINLOOSE]})\\s+-\\s+(${src[t.XRANGEPLAINLOOSE]})\\s*$`);
	createToken("STAR", "(<|>)?=?\\s*\\*");
	createToken("GTE0", "^\\s*>=\\s*0\\.0\\.0\\s*$");
	createToken("GTE0PRE", "^\\s*>=\\s*0\\.0\\.0-0\\s*$");
}));
// node_modules/semver/internal/parse-options.js
var require_parse_options = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	var looseOption = Object.freeze({ loose: true });
	var emptyOpts = Object.freeze({});
	var parseOptions = (options) => {
		if (!options) return emptyOpts;
		if (typeof options !== "object") return looseOption;
		return options;
	};
	module.exports = parseOptions;
}));
// node_modules/semver/internal/identifiers.js
var require_identifiers = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	var numeric = /^[0-9]+$/;
	var compareIdentifiers = (a, b) => {
		if (typeof a === "number" && typeof b === "number") return a === b ? 0 : a < b ? -1 : 1;
		const anum = numeric.test(a);
		const bnum = numeric.test(b);
		if (anum && bnum) {
			a = +a;
			b = +b;
		}
		return a === b ? 0 : anum && !bnum ? -1 : bnum && !anum ? 1 : a < b ? -1 : 1;
	};
	var rcompareIdentifiers = (a, b) => compareIdentifiers(b, a);
	module.exports = {
		compareIdentifiers,
		rcompareIdentifiers
	};
}));
// node_modules/semver/classes/semver.js
var require_semver = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	var debug = require_debug();
	var { MAX_LENGTH, MAX_SAFE_INTEGER } = require_constants();
	var { safeRe: re, t } = require_re();
	var parseOptions = require_parse_options();
	var { compareIdentifiers } = require_identifiers();
	var isPrereleaseIdentifier = (prerelease, identifier) => {
		const identifiers = identifier.split(".");
		if (identifiers.length > prerelease.length) return false;
		for (let i = 0; i < identifiers.length; i++) if (compareIdentifiers(prerelease[i], identifiers[i]) !== 0) return false;
		return true;
	};
	module.exports = class SemVer {
		constructor(version, options) {
			options = parseOptions(options);
			if (version instanceof SemVer) {
				if (version.loose === !!options.loose && version.includePrerelease === !!options.includePrerelease) return version;
				else version = version.version;
			} else if (typeof version !== "string") throw new TypeError(`Invalid version. Must be a string. Got type "${typeof version}".`);
			if (version.length > MAX_LENGTH) throw new TypeError(`version is longer than ${MAX_LENGTH} characters`);
			debug("SemVer", version, options);
			this.options = options;
			this.loose = !!options.loose;
			this.includePrerelease = !!options.includePrerelease;
			const m = version.trim().match(options.loose ? re[t.LOOSE] : re[t.FULL]);
			if (!m) throw new TypeError(`Invalid Version: ${version}`);
			this.raw = version;
			this.major = +m[1];
			this.minor = +m[2];
			this.patch = +m[3];
			if (this.major > MAX_SAFE_INTEGER || this.major < 0) throw new TypeError("Invalid major version");
			if (this.minor > MAX_SAFE_INTEGER || this.minor < 0) throw new TypeError("Invalid minor version");
			if (this.patch > MAX_SAFE_INTEGER || this.patch < 0) throw new TypeError("Invalid patch version");
			if (!m[4]) this.prerelease = [];
			else this.prerelease = m[4].split(".").map((id) => {
				if (/^[0-9]+$/.test(id)) {
					const num = +id;
					if (num >= 0 && num < MAX_SAFE_INTEGER) return num;
				}
				return id;
			});
			this.build = m[5] ? m[5].split(".") : [];
			this.format();
		}
		format() {
			this.version = `${this.major}.${this.minor}.${this.patch}`;
			if (this.prerelease.length) this.version += `-${this.prerelease.join(".")}`;
			return this.version;
		}
		toString() {
			return this.version;
		}
		compare(other) {
			debug("SemVer.compare", this.version, this.options, other);
			if (!(other instanceof SemVer)) {
				if (typeof other === "string" && other === this.version) return 0;
				other = new SemVer(other, this.options);
			}
			if (other.version === this.version) return 0;
			return this.compareMain(other) || this.comparePre(other);
		}
		compareMain(other) {
			if (!(other instanceof SemVer)) other = new SemVer(other, this.options);
			if (this.major < other.major) return -1;
			if (this.major > other.major) return 1;
			if (this.minor < other.minor) return -1;
			if (this.minor > other.minor) return 1;
			if (this.patch < other.patch) return -1;
			if (this.patch > other.patch) return 1;
			return 0;
		}
		comparePre(other) {
			if (!(other instanceof SemVer)) other = new SemVer(other, this.options);
			if (this.prerelease.length && !other.prerelease.length) return -1;
			else if (!this.prerelease.length && other.prerelease.length) return 1;
			else if (!this.prerelease.length && !other.prerelease.length) return 0;
			let i = 0;
			do {
				const a = this.prerelease[i];
				const b = other.prerelease[i];
				debug("prerelease compare", i, a, b);
				if (a === void 0 && b === void 0) return 0;
				else if (b === void 0) return 1;
				else if (a === void 0) return -1;
				else if (a === b) continue;
				else return compareIdentifiers(a, b);
			} while (++i);
		}
		compareBuild(other) {
			if (!(other instanceof SemVer)) other = new SemVer(other, this.options);
			let i = 0;
			do {
				const a = this.build[i];
				const b = other.build[i];
				debug("build compare", i, a, b);
				if (a === void 0 && b === void 0) return 0;
				else if (b === void 0) return 1;
				else if (a === void 0) return -1;
				else if (a === b) continue;
				else return compareIdentifiers(a, b);
			} while (++i);
		}
		inc(release, identifier, identifierBase) {
			if (release.startsWith("pre")) {
				if (!identifier && identifierBase === false) throw new Error("invalid increment argument: identifier is empty");
				if (identifier) {
					const match = `-${identifier}`.match(this.options.loose ? re[t.PRERELEASELOOSE] : re[t.PRERELEASE]);
					if (!match || match[1] !== identifier) throw new Error(`invalid identifier: ${identifier}`);
				}
			}
			switch (release) {
				case "premajor":
					this.prerelease.length = 0;
					this.patch = 0;
					this.minor = 0;
					this.major++;
					this.inc("pre", identifier, identifierBase);
					break;
				case "preminor":
					this.prerelease.length = 0;
					this.patch = 0;
					this.minor++;
					this.inc("pre", identifier, identifierBase);
					break;
				case "prepatch":
					this.prerelease.length = 0;
					this.inc("patch", identifier, identifierBase);
					this.inc("pre", identifier, identifierBase);
					break;
				case "prerelease":
					if (this.prerelease.length === 0) this.inc("patch", identifier, identifierBase);
					this.inc("pre", identifier, identifierBase);
					break;
				case "release":
					if (this.prerelease.length === 0) throw new Error(`version ${this.raw} is not a prerelease`);
					this.prerelease.length = 0;
					break;
				case "major":
					if (this.minor !== 0 || this.patch !== 0 || this.prerelease.length === 0) this.major++;
					this.minor = 0;
					this.patch = 0;
					this.prerelease = [];
					break;
				case "minor":
					if (this.patch !== 0 || this.prerelease.length === 0) this.minor++;
					this.patch = 0;
					this.prerelease = [];
					break;
				case "patch":
					if (this.prerelease.length === 0) this.patch++;
					this.prerelease = [];
					break;
				case "pre": {
					const base = Number(identifierBase) ? 1 : 0;
					if (this.prerelease.length === 0) this.prerelease = [base];
					else {
						let i = this.prerelease.length;
						while (--i >= 0) if (typeof this.prerelease[i] === "number") {
							this.prerelease[i]++;
							i = -2;
						}
						if (i === -1) {
							if (identifier === this.prerelease.join(".") && identifierBase === false) throw new Error("invalid increment argument: identifier already exists");
							this.prerelease.push(base);
						}
					}
					if (identifier) {
						let prerelease = [identifier, base];
						if (identifierBase === false) prerelease = [identifier];
						if (isPrereleaseIdentifier(this.prerelease, identifier)) {
							const prereleaseBase = this.prerelease[identifier.split(".").length];
							if (isNaN(prereleaseBase)) this.prerelease = prerelease;
						} else this.prerelease = prerelease;
					}
					break;
				}
				default: throw new Error(`invalid increment argument: ${release}`);
			}
			this.raw = this.format();
			if (this.build.length) this.raw += `+${this.build.join(".")}`;
			return this;
		}
	};
}));
// node_modules/semver/functions/parse.js
var require_parse = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	var SemVer = require_semver();
	var parse = (version, options, throwErrors = false) => {
		if (version instanceof SemVer) return version;
		try {
			return new SemVer(version, options);
		} catch (er) {
			if (!throwErrors) return null;
			throw er;
		}
	};
	module.exports = parse;
}));
// node_modules/semver/internal/lrucache.js
var require_lrucache = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	var LRUCache = class {
		constructor() {
			this.max = 1e3;
			this.map = /* @__PURE__ */ new Map();
		}
		get(key) {
			const value = this.map.get(key);
			if (value === void 0) return;
			else {
				this.map.delete(key);
				this.map.set(key, value);
				return value;
			}
		}
		delete(key) {
			return this.map.delete(key);
		}
		set(key, value) {
			if (!this.delete(key) && value !== void 0) {
				if (this.map.size >= this.max) {
					const firstKey = this.map.keys().next().value;
					this.delete(firstKey);
				}
				this.map.set(key, value);
			}
			return this;
		}
	};
	module.exports = LRUCache;
}));
// node_modules/semver/functions/compare.js
var require_compare = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	var SemVer = require_semver();
	var compare = (a, b, loose) => new SemVer(a, loose).compare(new SemVer(b, loose));
	module.exports = compare;
}));
// node_modules/semver/functions/eq.js
var require_eq = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	var compare = require_compare();
	var eq = (a, b, loose) => compare(a, b, loose) === 0;
	module.exports = eq;
}));
// node_modules/semver/functions/neq.js
var require_neq = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	var compare = require_compare();
	var neq = (a, b, loose) => compare(a, b, loose) !== 0;
	module.exports = neq;
}));
// node_modules/semver/functions/gt.js
var require_gt = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	var compare = require_compare();
	var gt = (a, b, loose) => compare(a, b, loose) > 0;
	module.exports = gt;
}));
// node_modules/semver/functions/gte.js
var require_gte = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	var compare = require_compare();
	var gte = (a, b, loose) => compare(a, b, loose) >= 0;
	module.exports = gte;
}));
// node_modules/semver/functions/lt.js
var require_lt = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	var compare = require_compare();
	var lt = (a, b, loose) => compare(a, b, loose) < 0;
	module.exports = lt;
}));
// node_modules/semver/functions/lte.js
var require_lte = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	var compare = require_compare();
	var lte = (a, b, loose) => compare(a, b, loose) <= 0;
	module.exports = lte;
}));
// node_modules/semver/functions/cmp.js
var require_cmp = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	var eq = require_eq();
	var neq = require_neq();
	var gt = require_gt();
	var gte = require_gte();
	var lt = require_lt();
	var lte = require_lte();
	var cmp = (a, op, b, loose) => {
		switch (op) {
			case "===":
				if (typeof a === "object") a = a.version;
				if (typeof b === "object") b = b.version;
				return a === b;
			case "!==":
				if (typeof a === "object") a = a.version;
				if (typeof b === "object") b = b.version;
				return a !== b;
			case "":
			case "=":
			case "==": return eq(a, b, loose);
			case "!=": return neq(a, b, loose);
			case ">": return gt(a, b, loose);
			case ">=": return gte(a, b, loose);
			case "<": return lt(a, b, loose);
			case "<=": return lte(a, b, loose);
			default: throw new TypeError(`Invalid operator: ${op}`);
		}
	};
	module.exports = cmp;
}));
// node_modules/semver/classes/comparator.js
var require_comparator = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	var ANY = Symbol("SemVer ANY");
	module.exports = class Comparator {
		static get ANY() {
			return ANY;
		}
		constructor(comp, options) {
			options = parseOptions(options);
			if (comp instanceof Comparator) {
				if (comp.loose === !!options.loose) return comp;
				else comp = comp.value;
			}
			comp = comp.trim().split(/\s+/).join(" ");
			debug("comparator", comp, options);
			this.options = options;
			this.loose = !!options.loose;
			this.parse(comp);
			if (this.semver === ANY) this.value = "";
			else this.value = this.operator + this.semver.version;
			debug("comp", this);
		}
		parse(comp) {
			const r = this.options.loose ? re[t.COMPARATORLOOSE] : re[t.COMPARATOR];
			const m = comp.match(r);
			if (!m) throw new TypeError(`Invalid comparator: ${comp}`);
			this.operator = m[1] !== void 0 ? m[1] : "";
			if (this.operator === "=") this.operator = "";
			if (!m[2]) this.semver = ANY;
			else this.semver = new SemVer(m[2], this.options.loose);
		}
		toString() {
			return this.value;
		}
		test(version) {
			debug("Comparator.test", version, this.options.loose);
			if (this.semver === ANY || version === ANY) return true;
			if (typeof version === "string") try {
				version = new SemVer(version, this.options);
			} catch (er) {
				return false;
			}
			return cmp(version, this.operator, this.semver, this.options);
		}
		intersects(comp, options) {
			if (!(comp instanceof Comparator)) throw new TypeError("a Comparator is required");
			if (this.operator === "") {
				if (this.value === "") return true;
				return new Range(comp.value, options).test(this.value);
			} else if (comp.operator === "") {
				if (comp.value === "") return true;
				return new Range(this.value, options).test(comp.semver);
			}
			options = parseOptions(options);
			if (options.includePrerelease && (this.value === "<0.0.0-0" || comp.value === "<0.0.0-0")) return false;
			if (!options.includePrerelease && (this.value.startsWith("<0.0.0") || comp.value.startsWith("<0.0.0"))) return false;
			if (this.operator.startsWith(">") && comp.operator.startsWith(">")) return true;
			if (this.operator.startsWith("<") && comp.operator.startsWith("<")) return true;
			if (this.semver.version === comp.semver.version && this.operator.includes("=") && comp.operator.includes("=")) return true;
			if (cmp(this.semver, "<", comp.semver, options) && this.operator.startsWith(">") && comp.operator.startsWith("<")) return true;
			if (cmp(this.semver, ">", comp.semver, options) && this.operator.startsWith("<") && comp.operator.startsWith(">")) return true;
			return false;
		}
	};
	var parseOptions = require_parse_options();
	var { safeRe: re, t } = require_re();
	var cmp = require_cmp();
	var debug = require_debug();
	var SemVer = require_semver();
	var Range = require_range();
}));
// node_modules/semver/internal/trim-comparator-whitespace.js
var require_trim_comparator_whitespace = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	var { MAX_LENGTH, MAX_SAFE_BUILD_LENGTH, WHITESPACE_CHARACTERS } = require_constants();
	/**
	* Remembers the last two rows of digits so their characters need not be reread.
	* Positions start at -1 until a row has been found.
	*
	* @typedef {object} DigitRunCache
	* @property {number} start The first character of the most recently found row.
	* @property {number} end The position after that row's last character.
	* @property {number} previousStart The first character of the previous row.
	* @property {number} previousEnd The position after the previous row.
	*/
	var whitespace = /* @__PURE__ */ new Uint8Array(65536);
	for (const char of WHITESPACE_CHARACTERS) whitespace[char.charCodeAt(0)] = 1;
	/**
	* Checks whether a character is whitespace, like a space, tab, or newline.
	* Looking past the end of the string returns false.
	*
	* @param {string|undefined} char One character, or undefined past the string's end.
	* @returns {boolean} Whether the character is whitespace.
	* @example isWhitespace(' ') // true
	* @example isWhitespace('1') // false
	*/
	var isWhitespace = (char) => char !== void 0 && whitespace[char.charCodeAt(0)] === 1;
	/**
	* Checks for v, =, or whitespace before the version number.
	* These are historical version prefixes, not range operators:
	* < and > are handled separately, as are tilde and caret ranges.
	*
	* @param {string|undefined} char One character to check.
	* @returns {boolean} Whether the character can belong to a version prefix.
	* @example isVersionPrefix('=') // true
	* @example isVersionPrefix('>') // false
	*/
	var isVersionPrefix = (char) => char === "v" || char === "=" || isWhitespace(char);
	/**
	* Checks whether a character is one of the digits 0 through 9.
	*
	* @param {string|undefined} char One character to check.
	* @returns {boolean} Whether the character is an ASCII digit.
	* @example isDigit('7') // true
	* @example isDigit('.') // false
	*/
	var isDigit = (char) => char !== void 0 && char >= "0" && char <= "9";
	/**
	* Checks whether a character is an English letter, uppercase or lowercase.
	*
	* @param {string|undefined} char One character to check.
	* @returns {boolean} Whether the character is an ASCII letter.
	* @example isLetter('b') // true
	* @example isLetter('7') // false
	*/
	var isLetter = (char) => char !== void 0 && (char >= "a" && char <= "z" || char >= "A" && char <= "Z");
	/**
	* Checks for a letter, digit, or hyphen: the characters allowed inside
	* prerelease and build names such as beta-1.
	*
	* @param {string|undefined} char One character to check.
	* @returns {boolean} Whether the character can be part of an identifier.
	* @example isIdentifierCharacter('-') // true
	* @example isIdentifierCharacter('.') // false; dots separate identifiers
	*/
	var isIdentifierCharacter = (char) => isDigit(char) || isLetter(char) || char === "-";
	/**
	* Checks whether a version component can begin here: with a digit or
	* a wildcard such as x, X, or *.
	*
	* @param {string|undefined} char One character to check.
	* @returns {boolean} Whether a number or wildcard can start with this character.
	* @example isVersionStart('x') // true
	* @example isVersionStart('v') // false; v belongs to the prefix
	*/
	var isVersionStart = (char) => isDigit(char) || char === "x" || char === "X" || char === "*";
	/**
	* Finds the end of a row of digits, but returns no more than limit digits.
	* Remembers the last two rows so looking at them again does not reread them.
	*
	* @param {string} range The text to read; it is not changed.
	* @param {number} start The position of the first character to check.
	* @param {number} limit The most digit characters the returned match can include.
	* @param {DigitRunCache} digitRuns Shared cache of digit-run positions, updated in place.
	* @returns {number} The position after the matched digits, or start if none match.
	* @example findDigitsEndIndex('123abc', 0, 10, digitRuns) // 3, pointing at a
	* @example findDigitsEndIndex('123abc', 0, 2, digitRuns) // 2, pointing at the unread 3
	*/
	var findDigitsEndIndex = (range, start, limit, digitRuns) => {
		if (!isDigit(range[start])) return start;
		if (start >= digitRuns.start && start < digitRuns.end) return Math.min(start + limit, digitRuns.end);
		if (start >= digitRuns.previousStart && start < digitRuns.previousEnd) return Math.min(start + limit, digitRuns.previousEnd);
		let end = start + 1;
		while (isDigit(range[end])) end++;
		digitRuns.previousStart = digitRuns.start;
		digitRuns.previousEnd = digitRuns.end;
		digitRuns.start = start;
		digitRuns.end = end;
		return Math.min(start + limit, end);
	};
	/**
	* Reads a number using the old regex's length and leading-zero rules.
	* Strict mode reads just the first zero in 012; loose mode can read all three.
	*
	* @param {string} range The text to read; it is not changed.
	* @param {number} start The position where the number should begin.
	* @param {boolean} loose Whether to allow leading zeros.
	* @param {DigitRunCache} digitRuns Shared digit-run cache, updated as needed.
	* @returns {number} The position after the matched digits, not their numeric value.
	* @example findVersionNumberEndIndex('012', 0, false, digitRuns) // 1
	* @example findVersionNumberEndIndex('012', 0, true, digitRuns) // 3
	*/
	var findVersionNumberEndIndex = (range, start, loose, digitRuns) => {
		if (!loose && range[start] === "0") return start + 1;
		return findDigitsEndIndex(range, start, loose ? MAX_LENGTH : MAX_LENGTH + 1, digitRuns);
	};
	/**
	* Reads one piece of a prerelease name, such as beta or 1 in beta.1.
	* Tries the letter-or-hyphen form first, then the number-only form.
	*
	* @param {string} range The text to read; it is not changed.
	* @param {number} start The position where the identifier should begin.
	* @param {boolean} loose Whether numeric identifiers may have leading zeros.
	* @param {DigitRunCache} digitRuns Shared digit-run cache, updated as needed.
	* @returns {number} The position after the identifier, or start if none matches.
	* @example findPrereleaseIdentifierEndIndex('beta.1', 0, false, digitRuns) // 4, at the dot
	* @example findPrereleaseIdentifierEndIndex('001beta', 0, false, digitRuns) // 7
	*/
	var findPrereleaseIdentifierEndIndex = (range, start, loose, digitRuns) => {
		const digitsEnd = findDigitsEndIndex(range, start, MAX_LENGTH, digitRuns);
		if (isLetter(range[digitsEnd]) || range[digitsEnd] === "-") {
			let end = digitsEnd + 1;
			const limit = end + MAX_SAFE_BUILD_LENGTH;
			while (end < limit && isIdentifierCharacter(range[end])) end++;
			return end;
		}
		return findVersionNumberEndIndex(range, start, loose, digitRuns);
	};
	/**
	* Reads a prerelease suffix such as -beta.1, one dot-separated piece at a time.
	* Loose mode also allows the name without its opening hyphen.
	*
	* @param {string} range The text to read; it is not changed.
	* @param {number} start The position where the suffix should begin, including -.
	* @param {boolean} loose Whether the opening hyphen is optional and zeros allowed.
	* @param {DigitRunCache} digitRuns Shared digit-run cache, updated as needed.
	* @returns {number} The position after the matched suffix, or start if absent.
	* @example findPrereleaseEndIndex('-beta.1+sha', 0, false, digitRuns) // 7, at the plus
	* @example findPrereleaseEndIndex('beta', 0, false, digitRuns) // 0; no opening hyphen
	*/
	var findPrereleaseEndIndex = (range, start, loose, digitRuns) => {
		const hyphen = range[start] === "-";
		if (!loose && !hyphen) return start;
		const identifierStart = start + (hyphen ? 1 : 0);
		let end = findPrereleaseIdentifierEndIndex(range, identifierStart, loose, digitRuns);
		if (end === identifierStart) {
			if (!loose || !hyphen) return start;
			end = findPrereleaseIdentifierEndIndex(range, start, loose, digitRuns);
		}
		while (range[end] === ".") {
			const next = findPrereleaseIdentifierEndIndex(range, end + 1, loose, digitRuns);
			if (next === end + 1) break;
			end = next;
		}
		return end;
	};
	/**
	* Reads one build-name piece, such as sha or 123 in +sha.123.
	* Stops at a disallowed character or the old regex's length limit.
	*
	* @param {string} range The text to read; it is not changed.
	* @param {number} start The position where the identifier should begin.
	* @returns {number} The position after the identifier, or start if none matches.
	* @example findBuildIdentifierEndIndex('sha.123', 0) // 3, at the dot
	* @example findBuildIdentifierEndIndex('001', 0) // 3; leading zeros are allowed
	*/
	var findBuildIdentifierEndIndex = (range, start) => {
		let end = start;
		while (end - start < MAX_SAFE_BUILD_LENGTH && isIdentifierCharacter(range[end])) end++;
		return end;
	};
	/**
	* Reads optional build metadata such as +sha.123.
	* Leaves the position unchanged if there is no plus sign followed by a name.
	*
	* @param {string} range The text to read; it is not changed.
	* @param {number} start The position where the opening + should be.
	* @returns {number} The position after the matched metadata, or start if absent.
	* @example findBuildEndIndex('+sha.123 <2', 0) // 8, at the space
	* @example findBuildEndIndex('+', 0) // 0; a plus sign alone is not a match
	*/
	var findBuildEndIndex = (range, start) => {
		if (range[start] !== "+") return start;
		let end = findBuildIdentifierEndIndex(range, start + 1);
		if (end === start + 1) return start;
		while (range[end] === ".") {
			const next = findBuildIdentifierEndIndex(range, end + 1);
			if (next === end + 1) break;
			end = next;
		}
		return end;
	};
	/**
	* Reads three numbers separated by dots, then any prerelease and build suffixes.
	* Uses loose rules, so forms such as 01.02.03beta can match here.
	*
	* @param {string} range The text to read; it is not changed.
	* @param {number} start The position of the first number, after any prefix.
	* @param {DigitRunCache} digitRuns Shared digit-run cache, updated as needed.
	* @returns {number} The position after the version match, or start if none matches.
	* @example findLooseFullVersionEndIndex('1.2.3-beta+sha <2', 0, digitRuns) // 14
	* @example findLooseFullVersionEndIndex('1.2', 0, digitRuns) // 0; needs three numbers
	*/
	var findLooseFullVersionEndIndex = (range, start, digitRuns) => {
		let end = start;
		for (let component = 0; component < 3; component++) {
			const next = findVersionNumberEndIndex(range, end, true, digitRuns);
			if (next === end) return start;
			end = next;
			if (component < 2) {
				if (range[end] !== ".") return start;
				end++;
			}
		}
		return findBuildEndIndex(range, findPrereleaseEndIndex(range, end, true, digitRuns));
	};
	/**
	* Reads one component of a partial or wildcard version, such as 2 or x in 2.x.
	* Numbers use strict leading-zero rules; wildcards take up one character.
	*
	* @param {string} range The text to read; it is not changed.
	* @param {number} start The position where the component should begin.
	* @param {DigitRunCache} digitRuns Shared digit-run cache, updated as needed.
	* @returns {number} The position after the component, or start if none matches.
	* @example findPartialVersionComponentEndIndex('2.x', 0, digitRuns) // 1, at the dot
	* @example findPartialVersionComponentEndIndex('2.x', 2, digitRuns) // 3, after x
	*/
	var findPartialVersionComponentEndIndex = (range, start, digitRuns) => {
		if (isDigit(range[start])) return findVersionNumberEndIndex(range, start, false, digitRuns);
		return isVersionStart(range[start]) ? start + 1 : start;
	};
	/**
	* Reads up to three components, allowing forms such as 1, 1.2, or 1.x.
	* After the third component, also reads any strict prerelease and build suffixes.
	*
	* @param {string} range The text to read; it is not changed.
	* @param {number} start The position of a number or wildcard, after any prefix.
	* @param {DigitRunCache} digitRuns Shared digit-run cache, updated as needed.
	* @returns {number} The position after the matched version text.
	* @example findPartialVersionEndIndex('1.x <2', 0, digitRuns) // 3, at the space
	* @example findPartialVersionEndIndex('1.', 0, digitRuns) // 1; the trailing dot is unread
	*/
	var findPartialVersionEndIndex = (range, start, digitRuns) => {
		let end = findPartialVersionComponentEndIndex(range, start, digitRuns);
		for (let component = 0; component < 2; component++) {
			if (range[end] !== ".") return end;
			const next = findPartialVersionComponentEndIndex(range, end + 1, digitRuns);
			if (next === end + 1) return end;
			end = next;
		}
		return findBuildEndIndex(range, findPrereleaseEndIndex(range, end, false, digitRuns));
	};
	/**
	* Finds where a version match ends, without deciding whether the range is valid.
	* Tries a loose full version first, then a partial or wildcard version, just
	* like the old regex's LOOSEPLAIN and XRANGEPLAIN alternatives.
	*
	* @param {string} range The text to read; it is not changed.
	* @param {number} start The position of a number or wildcard, after any prefix.
	* @param {DigitRunCache} digitRuns Shared digit-run cache, updated as needed.
	* @returns {number} The position where scanning the next candidate can resume.
	* @example findVersionEndIndex('1.2.3 <2', 0, digitRuns) // 5, at the space
	* @example findVersionEndIndex('1.x <2', 0, digitRuns) // 3, at the space
	*/
	var findVersionEndIndex = (range, start, digitRuns) => {
		const fullVersionEnd = findLooseFullVersionEndIndex(range, start, digitRuns);
		return fullVersionEnd !== start ? fullVersionEnd : findPartialVersionEndIndex(range, start, digitRuns);
	};
	/**
	* Finds the one whitespace character the old replacement would remove.
	* Keeps leading whitespace, skips an optional operator, and checks immediately
	* after it. Returns -1 if there is nothing to remove.
	*
	* @param {string} range The text containing a candidate already found by the caller.
	* @param {number} matchStart The candidate's position, including leading whitespace.
	* @returns {number} The position of the removable whitespace, or -1 if absent.
	* @example findRemovableWhitespaceIndex(' > 1', 0) // 2; keep the space at position 0
	* @example findRemovableWhitespaceIndex('>1', 0) // -1
	*/
	var findRemovableWhitespaceIndex = (range, matchStart) => {
		let position = matchStart;
		if (isWhitespace(range[position])) position++;
		if (range[position] === "<" || range[position] === ">") position++;
		if (range[position] === "=") position++;
		return isWhitespace(range[position]) ? position : -1;
	};
	/**
	* Joins an operator to its version, turning > 1.2.3 into >1.2.3.
	* Copies everything else according to the old regex's matching rules.
	* Moves forward through prefixes and whole versions to avoid repeatedly
	* searching the same characters on long inputs.
	*
	* @param {string} range The range text to process; the original string is unchanged.
	* @returns {string} The range with matched operator whitespace removed.
	* @example trimComparatorWhitespace('> 1.2.3 < 2') // '>1.2.3 <2'
	* @example trimComparatorWhitespace('> invalid') // '> invalid'
	*/
	var trimComparatorWhitespace = (range) => {
		let result = "";
		let copyFrom = 0;
		let cursor = 0;
		const digitRuns = {
			start: -1,
			end: -1,
			previousStart: -1,
			previousEnd: -1
		};
		while (cursor < range.length) {
			const matchStart = cursor;
			if (range[cursor] === "<" || range[cursor] === ">") cursor++;
			else if (!isVersionPrefix(range[cursor]) && !isVersionStart(range[cursor])) {
				cursor++;
				continue;
			}
			while (cursor < range.length && isVersionPrefix(range[cursor])) cursor++;
			if (!isVersionStart(range[cursor])) continue;
			const whitespacePosition = findRemovableWhitespaceIndex(range, matchStart);
			if (whitespacePosition !== -1) {
				result += range.slice(copyFrom, whitespacePosition);
				copyFrom = whitespacePosition + 1;
			}
			cursor = findVersionEndIndex(range, cursor, digitRuns);
		}
		return result + range.slice(copyFrom);
	};
	module.exports = trimComparatorWhitespace;
}));
// node_modules/semver/classes/range.js
var require_range = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	var SPACE_CHARACTERS = /\s+/g;
	module.exports = class Range {
		constructor(range, options) {
			options = parseOptions(options);
			if (range instanceof Range) {
				if (range.loose === !!options.loose && range.includePrerelease === !!options.includePrerelease) return range;
				else return new Range(range.raw, options);
			}
			if (range instanceof Comparator) {
				this.raw = range.value;
				this.set = [[range]];
				this.formatted = void 0;
				return this;
			}
			this.options = options;
			this.loose = !!options.loose;
			this.includePrerelease = !!options.includePrerelease;
			this.raw = range.trim().replace(SPACE_CHARACTERS, " ");
			this.set = this.raw.split("||").map((r) => this.parseRange(r.trim())).filter((c) => c.length);
			if (!this.set.length) throw new TypeError(`Invalid SemVer Range: ${this.raw}`);
			if (this.set.length > 1) {
				const first = this.set[0];
				this.set = this.set.filter((c) => !isNullSet(c[0]));
				if (this.set.length === 0) this.set = [first];
				else if (this.set.length > 1) {
					for (const c of this.set) if (c.length === 1 && isAny(c[0])) {
						this.set = [c];
						break;
					}
				}
			}
			this.formatted = void 0;
		}
		get range() {
			if (this.formatted === void 0) {
				this.formatted = "";
				for (let i = 0; i < this.set.length; i++) {
					if (i > 0) this.formatted += "||";
					const comps = this.set[i];
					for (let k = 0; k < comps.length; k++) {
						if (k > 0) this.formatted += " ";
						this.formatted += comps[k].toString().trim();
					}
				}
			}
			return this.formatted;
		}
		format() {
			return this.range;
		}
		toString() {
			return this.range;
		}
		parseRange(range) {
			range = range.replace(BUILDSTRIPRE, "");
			const memoKey = ((this.options.includePrerelease && FLAG_INCLUDE_PRERELEASE) | (this.options.loose && FLAG_LOOSE)) + ":" + range;
			const cached = cache.get(memoKey);
			if (cached) return cached;
			const loose = this.options.loose;
			const hr = loose ? re[t.HYPHENRANGELOOSE] : re[t.HYPHENRANGE];
			range = range.replace(hr, hyphenReplace(this.options.includePrerelease));
			debug("hyphen replace", range);
			range = trimComparatorWhitespace(range);
			debug("comparator trim", range);
			range = range.replace(re[t.TILDETRIM], tildeTrimReplace);
			debug("tilde trim", range);
			range = range.replace(re[t.CARETTRIM], caretTrimReplace);
			debug("caret trim", range);
			let rangeList = range.split(" ").map((comp) => parseComparator(comp, this.options)).join(" ").split(/\s+/).map((comp) => replaceGTE0(comp, this.options));
			if (loose) rangeList = rangeList.filter((comp) => {
				debug("loose invalid filter", comp, this.options);
				return !!comp.match(re[t.COMPARATORLOOSE]);
			});
			debug("range list", rangeList);
			const rangeMap = /* @__PURE__ */ new Map();
			const comparators = rangeList.map((comp) => new Comparator(comp, this.options));
			for (const comp of comparators) {
				if (isNullSet(comp)) return [comp];
				rangeMap.set(comp.value, comp);
			}
			if (rangeMap.size > 1 && rangeMap.has("")) rangeMap.delete("");
			const result = [...rangeMap.values()];
			cache.set(memoKey, result);
			return result;
		}
		intersects(range, options) {
			if (!(range instanceof Range)) throw new TypeError("a Range is required");
			return this.set.some((thisComparators) => {
				return isSatisfiable(thisComparators, options) && range.set.some((rangeComparators) => {
					return isSatisfiable(rangeComparators, options) && thisComparators.every((thisComparator) => {
						return rangeComparators.every((rangeComparator) => {
							return thisComparator.intersects(rangeComparator, options);
						});
					});
				});
			});
		}
		test(version) {
			if (!version) return false;
			if (typeof version === "string") try {
				version = new SemVer(version, this.options);
			} catch (er) {
				return false;
			}
			for (let i = 0; i < this.set.length; i++) if (testSet(this.set[i], version, this.options)) return true;
			return false;
		}
	};
	var cache = new (require_lrucache())();
	var parseOptions = require_parse_options();
	var Comparator = require_comparator();
	var debug = require_debug();
	var SemVer = require_semver();
	var trimComparatorWhitespace = require_trim_comparator_whitespace();
	var { safeRe: re, src, t, tildeTrimReplace, caretTrimReplace } = require_re();
	var { FLAG_INCLUDE_PRERELEASE, FLAG_LOOSE } = require_constants();
	var BUILDSTRIPRE = new RegExp(src[t.BUILD], "g");
	var isNullSet = (c) => c.value === "<0.0.0-0";
	var isAny = (c) => c.value === "";
	var isSatisfiable = (comparators, options) => {
		let result = true;
		const remainingComparators = comparators.slice();
		let testComparator = remainingComparators.pop();
		while (result && remainingComparators.length) {
			result = remainingComparators.every((otherComparator) => {
				return testComparator.intersects(otherComparator, options);
			});
			testComparator = remainingComparators.pop();
		}
		return result;
	};
	var parseComparator = (comp, options) => {
		comp = comp.replace(re[t.BUILD], "");
		debug("comp", comp, options);
		comp = replaceCarets(comp, options);
		debug("caret", comp);
		comp = replaceTildes(comp, options);
		debug("tildes", comp);
		comp = replaceXRanges(comp, options);
		debug("xrange", comp);
		comp = replaceStars(comp, options);
		debug("stars", comp);
		return comp;
	};
	var isX = (id) => !id || id.toLowerCase() === "x" || id === "*";
	var invalidXRangeOrder = (M, m, p) => isX(M) && !isX(m) || isX(m) && p && !isX(p);
	var replaceTildes = (comp, options) => {
		return comp.trim().split(/\s+/).map((c) => replaceTilde(c, options)).join(" ");
	};
	var replaceTilde = (comp, options) => {
		const r = options.loose ? re[t.TILDELOOSE] : re[t.TILDE];
		const z = options.includePrerelease ? "-0" : "";
		return comp.replace(r, (_, M, m, p, pr) => {
			debug("tilde", comp, _, M, m, p, pr);
			let ret;
			if (isX(M)) ret = "";
			else if (isX(m)) ret = `>=${M}.0.0${z} <${+M + 1}.0.0-0`;
			else if (isX(p)) ret = `>=${M}.${m}.0${z} <${M}.${+m + 1}.0-0`;
			else if (pr) {
				debug("replaceTilde pr", pr);
				ret = `>=${M}.${m}.${p}-${pr} <${M}.${+m + 1}.0-0`;
			} else ret = `>=${M}.${m}.${p} <${M}.${+m + 1}.0-0`;
			debug("tilde return", ret);
			return ret;
		});
	};
	var replaceCarets = (comp, options) => {
		return comp.trim().split(/\s+/).map((c) => replaceCaret(c, options)).join(" ");
	};
	var replaceCaret = (comp, options) => {
		debug("caret", comp, options);
		const r = options.loose ? re[t.CARETLOOSE] : re[t.CARET];
		const z = options.includePrerelease ? "-0" : "";
		return comp.replace(r, (_, M, m, p, pr) => {
			debug("caret", comp, _, M, m, p, pr);
			let ret;
			if (isX(M)) ret = "";
			else if (isX(m)) ret = `>=${M}.0.0${z} <${+M + 1}.0.0-0`;
			else if (isX(p)) {
				if (M === "0") ret = `>=${M}.${m}.0${z} <${M}.${+m + 1}.0-0`;
				else ret = `>=${M}.${m}.0${z} <${+M + 1}.0.0-0`;
			} else if (pr) {
				debug("replaceCaret pr", pr);
				if (M === "0") {
					if (m === "0") ret = `>=${M}.${m}.${p}-${pr} <${M}.${m}.${+p + 1}-0`;
					else ret = `>=${M}.${m}.${p}-${pr} <${M}.${+m + 1}.0-0`;
				} else ret = `>=${M}.${m}.${p}-${pr} <${+M + 1}.0.0-0`;
			} else {
				debug("no pr");
				if (M === "0") {
					if (m === "0") ret = `>=${M}.${m}.${p} <${M}.${m}.${+p + 1}-0`;
					else ret = `>=${M}.${m}.${p} <${M}.${+m + 1}.0-0`;
				} else ret = `>=${M}.${m}.${p} <${+M + 1}.0.0-0`;
			}
			debug("caret return", ret);
			return ret;
		});
	};
	var replaceXRanges = (comp, options) => {
		debug("replaceXRanges", comp, options);
		return comp.split(/\s+/).map((c) => replaceXRange(c, options)).join(" ");
	};
	var replaceXRange = (comp, options) => {
		comp = comp.trim();
		const r = options.loose ? re[t.XRANGELOOSE] : re[t.XRANGE];
		return comp.replace(r, (ret, gtlt, M, m, p, pr) => {
			debug("xRange", comp, ret, gtlt, M, m, p, pr);
			if (invalidXRangeOrder(M, m, p)) return comp;
			const xM = isX(M);
			const xm = xM || isX(m);
			const xp = xm || isX(p);
			const anyX = xp;
			if (gtlt === "=" && anyX) gtlt = "";
			pr = options.includePrerelease ? "-0" : "";
			if (xM) {
				if (gtlt === ">" || gtlt === "<") ret = "<0.0.0-0";
				else ret = "*";
			} else if (gtlt && anyX) {
				if (xm) m = 0;
				p = 0;
				if (gtlt === ">") {
					gtlt = ">=";
					if (xm) {
						M = +M + 1;
						m = 0;
						p = 0;
					} else {
						m = +m + 1;
						p = 0;
					}
				} else if (gtlt === "<=") {
					gtlt = "<";
					if (xm) M = +M + 1;
					else m = +m + 1;
				}
				if (gtlt === "<") pr = "-0";
				ret = `${gtlt + M}.${m}.${p}${pr}`;
			} else if (xm) ret = `>=${M}.0.0${pr} <${+M + 1}.0.0-0`;
			else if (xp) ret = `>=${M}.${m}.0${pr} <${M}.${+m + 1}.0-0`;
			debug("xRange return", ret);
			return ret;
		});
	};
	var replaceStars = (comp, options) => {
		debug("replaceStars", comp, options);
		return comp.trim().replace(re[t.STAR], "");
	};
	var replaceGTE0 = (comp, options) => {
		debug("replaceGTE0", comp, options);
		return comp.trim().replace(re[options.includePrerelease ? t.GTE0PRE : t.GTE0], "");
	};
	var hyphenReplace = (incPr) => ($0, from, fM, fm, fp, fpr, fb, to, tM, tm, tp, tpr) => {
		if (isX(fM)) from = "";
		else if (isX(fm)) from = `>=${fM}.0.0${incPr ? "-0" : ""}`;
		else if (isX(fp)) from = `>=${fM}.${fm}.0${incPr ? "-0" : ""}`;
		else if (fpr) from = `>=${from}`;
		else from = `>=${from}${incPr ? "-0" : ""}`;
		if (isX(tM)) to = "";
		else if (isX(tm)) to = `<${+tM + 1}.0.0-0`;
		else if (isX(tp)) to = `<${tM}.${+tm + 1}.0-0`;
		else if (tpr) to = `<=${tM}.${tm}.${tp}-${tpr}`;
		else if (incPr) to = `<${tM}.${tm}.${+tp + 1}-0`;
		else to = `<=${to}`;
		return `${from} ${to}`.trim();
	};
	var testSet = (set, version, options) => {
		for (let i = 0; i < set.length; i++) if (!set[i].test(version)) return false;
		if (version.prerelease.length && !options.includePrerelease) {
			for (let i = 0; i < set.length; i++) {
				debug(set[i].semver);
				if (set[i].semver === Comparator.ANY) continue;
				if (set[i].semver.prerelease.length > 0) {
					const allowed = set[i].semver;
					if (allowed.major === version.major && allowed.minor === version.minor && allowed.patch === version.patch) return true;
				}
			}
			return false;
		}
		return true;
	};
}));
// node_modules/semver/functions/satisfies.js
var require_satisfies = /* @__PURE__ */ __commonJSMin(((exports, module) => {
	var Range = require_range();
	var satisfies = (version, range, options) => {
		try {
			range = new Range(range, options);
		} catch (er) {
			return false;
		}
		return range.test(version);
	};
	module.exports = satisfies;
}));
// node_modules/vscode-languageclient/lib/common/api.js
var require_api = /* @__PURE__ */ __commonJSMin(((exports, module, this$2) => {
	var __createBinding = this$2 && this$2.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __exportStar = this$2 && this$2.__exportStar || function(m, exports) {
		for (var p in m) if (p !== "default" && !Object.prototype.hasOwnProperty.call(exports, p)) __createBinding(exports, m, p);
	};
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.DiagnosticPullMode = exports.vsdiag = void 0;
	__exportStar(require_api$1(), exports);
	__exportStar(require_features(), exports);
	var diagnostic_1 = require_diagnostic();
	Object.defineProperty(exports, "vsdiag", {
		enumerable: true,
		get: function() {
			return diagnostic_1.vsdiag;
		}
	});
	Object.defineProperty(exports, "DiagnosticPullMode", {
		enumerable: true,
		get: function() {
			return diagnostic_1.DiagnosticPullMode;
		}
	});
	__exportStar(require_client(), exports);
}));
// src/command.ts
var import_main = (/* @__PURE__ */ __commonJSMin(((exports, module, this$1) => {
	var __createBinding = this$1 && this$1.__createBinding || (Object.create ? (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		var desc = Object.getOwnPropertyDescriptor(m, k);
		if (!desc || ("get" in desc ? !m.__esModule : desc.writable || desc.configurable)) desc = {
			enumerable: true,
			get: function() {
				return m[k];
			}
		};
		Object.defineProperty(o, k2, desc);
	}) : (function(o, m, k, k2) {
		if (k2 === void 0) k2 = k;
		o[k2] = m[k];
	}));
	var __setModuleDefault = this$1 && this$1.__setModuleDefault || (Object.create ? (function(o, v) {
		Object.defineProperty(o, "default", {
			enumerable: true,
			value: v
		});
	}) : function(o, v) {
		o["default"] = v;
	});
	var __importStar = this$1 && this$1.__importStar || (function() {
		var ownKeys = function(o) {
			ownKeys = Object.getOwnPropertyNames || function(o) {
				var ar = [];
				for (var k in o) if (Object.prototype.hasOwnProperty.call(o, k)) ar[ar.length] = k;
				return ar;
			};
			return ownKeys(o);
		};
		return function(mod) {
			if (mod && mod.__esModule) return mod;
			var result = {};
			if (mod != null) {
				for (var k = ownKeys(mod), i = 0; i < k.length; i++) if (k[i] !== "default") __createBinding(result, mod, k[i]);
			}
			__setModuleDefault(result, mod);
			return result;
		};
	})();
	var __exportStar = this$1 && this$1.__exportStar || function(m, exports) {
		for (var p in m) if (p !== "default" && !Object.prototype.hasOwnProperty.call(exports, p)) __createBinding(exports, m, p);
	};
	Object.defineProperty(exports, "__esModule", { value: true });
	exports.SettingMonitor = exports.LanguageClient = exports.TransportKind = void 0;
	var cp = __importStar(require("child_process"));
	var fs = __importStar(require("fs"));
	var path = __importStar(require("path"));
	var readline = __importStar(require("readline"));
	var vscode_1 = require("vscode");
	var Is = __importStar(require_is$2());
	var client_1 = require_client();
	var processes_1 = require_processes();
	var node_1 = require_main$1();
	var semverParse = require_parse();
	var semverSatisfies = require_satisfies();
	__exportStar(require_main$1(), exports);
	__exportStar(require_api(), exports);
	var REQUIRED_VSCODE_VERSION = "^1.91.0";
	var TransportKind;
	(function(TransportKind) {
		TransportKind[TransportKind["stdio"] = 0] = "stdio";
		TransportKind[TransportKind["ipc"] = 1] = "ipc";
		TransportKind[TransportKind["pipe"] = 2] = "pipe";
		TransportKind[TransportKind["socket"] = 3] = "socket";
	})(TransportKind || (exports.TransportKind = TransportKind = {}));
	var Transport;
	(function(Transport) {
		function isSocket(value) {
			const candidate = value;
			return candidate && candidate.kind === TransportKind.socket && Is.number(candidate.port);
		}
		Transport.isSocket = isSocket;
	})(Transport || (Transport = {}));
	var Executable;
	(function(Executable) {
		function is(value) {
			return Is.string(value.command);
		}
		Executable.is = is;
	})(Executable || (Executable = {}));
	var NodeModule;
	(function(NodeModule) {
		function is(value) {
			return Is.string(value.module);
		}
		NodeModule.is = is;
	})(NodeModule || (NodeModule = {}));
	var StreamInfo;
	(function(StreamInfo) {
		function is(value) {
			const candidate = value;
			return candidate && candidate.writer !== void 0 && candidate.reader !== void 0;
		}
		StreamInfo.is = is;
	})(StreamInfo || (StreamInfo = {}));
	var ChildProcessInfo;
	(function(ChildProcessInfo) {
		function is(value) {
			const candidate = value;
			return candidate && candidate.process !== void 0 && typeof candidate.detached === "boolean";
		}
		ChildProcessInfo.is = is;
	})(ChildProcessInfo || (ChildProcessInfo = {}));
	var LanguageClient = class extends client_1.BaseLanguageClient {
		_serverOptions;
		_stdioOptions;
		_forceDebug;
		_serverProcess;
		_isDetached;
		_isInDebugMode;
		constructor(arg1, arg2, arg3, arg4, arg5) {
			let id;
			let name;
			let serverOptions;
			let clientOptions;
			let forceDebug;
			if (Is.string(arg2)) {
				id = arg1;
				name = arg2;
				serverOptions = arg3;
				clientOptions = arg4;
				forceDebug = !!arg5;
			} else {
				id = arg1.toLowerCase();
				name = arg1;
				serverOptions = arg2;
				clientOptions = arg3;
				forceDebug = arg4;
			}
			if (forceDebug === void 0) forceDebug = false;
			super(id, name, clientOptions);
			this._serverOptions = serverOptions;
			this._stdioOptions = clientOptions.stdioOptions ?? {
				stdout: (input, outputChannel) => {
					readline.createInterface({
						input,
						crlfDelay: Infinity,
						terminal: false,
						historySize: 0
					}).on("line", (data) => outputChannel.info(data));
				},
				stderr: (input, outputChannel) => {
					readline.createInterface({
						input,
						crlfDelay: Infinity,
						terminal: false,
						historySize: 0
					}).on("line", (data) => outputChannel.error(data));
				}
			};
			this._forceDebug = forceDebug;
			this._isInDebugMode = forceDebug;
			try {
				this.checkVersion();
			} catch (error) {
				if (Is.string(error.message)) this.outputChannel.appendLine(error.message);
				throw error;
			}
		}
		checkVersion() {
			const codeVersion = semverParse(vscode_1.version);
			if (!codeVersion) throw new Error(`No valid VS Code version detected. Version string is: ${vscode_1.version}`);
			if (codeVersion.prerelease && codeVersion.prerelease.length > 0) codeVersion.prerelease = [];
			if (!semverSatisfies(codeVersion, REQUIRED_VSCODE_VERSION)) throw new Error(`The language client requires VS Code version ${REQUIRED_VSCODE_VERSION} but received version ${vscode_1.version}`);
		}
		get isInDebugMode() {
			return this._isInDebugMode;
		}
		get serverProcess() {
			return this._serverProcess;
		}
		async restart() {
			await this.stop();
			if (this.isInDebugMode) {
				await new Promise((resolve) => setTimeout(resolve, 1e3));
				await this.start();
			} else await this.start();
		}
		shutdown(mode, timeout = 2e3) {
			return super.shutdown(mode, timeout).finally(() => {
				if (this._serverProcess) {
					const toCheck = this._serverProcess;
					this._serverProcess = void 0;
					if (this._isDetached === void 0 || !this._isDetached) this.checkProcessDied(toCheck);
					this._isDetached = void 0;
				}
			});
		}
		checkProcessDied(childProcess) {
			if (!childProcess || childProcess.pid === void 0) return;
			setTimeout(() => {
				try {
					if (childProcess.pid !== void 0) {
						process.kill(childProcess.pid, 0);
						(0, processes_1.terminate)(childProcess);
					}
				} catch (error) {}
			}, 2e3);
		}
		handleConnectionClosed() {
			this._serverProcess = void 0;
			return super.handleConnectionClosed();
		}
		fillInitializeParams(params) {
			super.fillInitializeParams(params);
			if (params.processId === null) params.processId = process.pid;
		}
		async createMessageTransports(_encoding) {
			function getEnvironment(env, fork) {
				if (!env && !fork) return;
				const result = Object.create(null);
				Object.keys(process.env).forEach((key) => result[key] = process.env[key]);
				if (fork) {
					result["ELECTRON_RUN_AS_NODE"] = "1";
					result["ELECTRON_NO_ASAR"] = "1";
				}
				if (env) Object.keys(env).forEach((key) => result[key] = env[key]);
				return result;
			}
			const debugStartWith = [
				"--debug=",
				"--debug-brk=",
				"--inspect=",
				"--inspect-brk="
			];
			const debugEquals = [
				"--debug",
				"--debug-brk",
				"--inspect",
				"--inspect-brk"
			];
			function startedInDebugMode() {
				const args = process.execArgv;
				if (args) return args.some((arg) => {
					return debugStartWith.some((value) => arg.startsWith(value)) || debugEquals.some((value) => arg === value);
				});
				return false;
			}
			function assertStdio(process) {
				if (process.stdin === null || process.stdout === null || process.stderr === null) throw new Error("Process created without stdio streams");
			}
			const pipeStdout = this._stdioOptions.stdout;
			const pipeStderr = this._stdioOptions.stderr;
			const server = this._serverOptions;
			if (Is.func(server)) return server().then((result) => {
				if (client_1.MessageTransports.is(result)) {
					this._isDetached = !!result.detached;
					return result;
				} else if (StreamInfo.is(result)) {
					this._isDetached = !!result.detached;
					return {
						reader: new node_1.StreamMessageReader(result.reader),
						writer: new node_1.StreamMessageWriter(result.writer)
					};
				} else {
					let cp;
					if (ChildProcessInfo.is(result)) {
						cp = result.process;
						this._isDetached = result.detached;
					} else {
						cp = result;
						this._isDetached = false;
					}
					pipeStderr(cp.stderr, this.outputChannel);
					return {
						reader: new node_1.StreamMessageReader(cp.stdout),
						writer: new node_1.StreamMessageWriter(cp.stdin)
					};
				}
			});
			let json;
			const runDebug = server;
			if (runDebug.run || runDebug.debug) {
				if (this._forceDebug || startedInDebugMode()) {
					json = runDebug.debug;
					this._isInDebugMode = true;
				} else {
					json = runDebug.run;
					this._isInDebugMode = false;
				}
			} else json = server;
			const startServer = (serverWorkingDir) => {
				if (NodeModule.is(json) && json.module) {
					const node = json;
					const transport = node.transport || TransportKind.stdio;
					if (node.runtime) {
						const args = [];
						const options = node.options ?? Object.create(null);
						if (options.execArgv) options.execArgv.forEach((element) => args.push(element));
						args.push(node.module);
						if (node.args) node.args.forEach((element) => args.push(element));
						const execOptions = Object.create(null);
						execOptions.cwd = serverWorkingDir;
						execOptions.env = getEnvironment(options.env, false);
						const runtime = this._getRuntimePath(node.runtime, serverWorkingDir);
						let pipeName = void 0;
						if (transport === TransportKind.ipc) {
							execOptions.stdio = [
								null,
								null,
								null,
								"ipc"
							];
							args.push("--node-ipc");
						} else if (transport === TransportKind.stdio) args.push("--stdio");
						else if (transport === TransportKind.pipe) {
							pipeName = (0, node_1.generateRandomPipeName)();
							args.push(`--pipe=${pipeName}`);
						}
						args.push(`--clientProcessId=${process.pid.toString()}`);
						if (transport === TransportKind.ipc || transport === TransportKind.stdio) {
							const serverProcess = cp.spawn(runtime, args, execOptions);
							if (!serverProcess || !serverProcess.pid) return handleChildProcessStartError(serverProcess, `Launching server using runtime ${runtime} failed.`);
							this._serverProcess = serverProcess;
							pipeStderr(serverProcess.stderr, this.outputChannel);
							if (transport === TransportKind.ipc) {
								pipeStdout(serverProcess.stdout, this.outputChannel);
								return Promise.resolve({
									reader: new node_1.IPCMessageReader(serverProcess),
									writer: new node_1.IPCMessageWriter(serverProcess)
								});
							} else return Promise.resolve({
								reader: new node_1.StreamMessageReader(serverProcess.stdout),
								writer: new node_1.StreamMessageWriter(serverProcess.stdin)
							});
						} else if (transport === TransportKind.pipe) return (0, node_1.createClientPipeTransport)(pipeName).then((transport) => {
							const process = cp.spawn(runtime, args, execOptions);
							if (!process || !process.pid) {
								transport.close();
								return handleChildProcessStartError(process, `Launching server using runtime ${runtime} failed.`);
							}
							this._serverProcess = process;
							pipeStderr(process.stderr, this.outputChannel);
							pipeStdout(process.stdout, this.outputChannel);
							return waitForConnection(process, transport);
						});
						else if (Transport.isSocket(transport)) return (0, node_1.createClientSocketTransport)(transport.port).then((transport) => {
							args.push(`--socket=${transport.port()}`);
							const process = cp.spawn(runtime, args, execOptions);
							if (!process || !process.pid) {
								transport.close();
								return handleChildProcessStartError(process, `Launching server using runtime ${runtime} failed.`);
							}
							this._serverProcess = process;
							pipeStderr(process.stderr, this.outputChannel);
							pipeStdout(process.stdout, this.outputChannel);
							return waitForConnection(process, transport);
						});
					} else {
						let pipeName = void 0;
						return new Promise((resolve, reject) => {
							const args = (node.args && node.args.slice()) ?? [];
							if (transport === TransportKind.ipc) args.push("--node-ipc");
							else if (transport === TransportKind.stdio) args.push("--stdio");
							else if (transport === TransportKind.pipe) {
								pipeName = (0, node_1.generateRandomPipeName)();
								args.push(`--pipe=${pipeName}`);
							}
							args.push(`--clientProcessId=${process.pid.toString()}`);
							const options = node.options ? { ...node.options } : Object.create(null);
							options.env = getEnvironment(options.env, true);
							options.execArgv = options.execArgv || [];
							options.cwd = serverWorkingDir;
							options.silent = true;
							if (transport === TransportKind.ipc || transport === TransportKind.stdio) {
								const sp = cp.fork(node.module, args || [], options);
								assertStdio(sp);
								this._serverProcess = sp;
								pipeStderr(sp.stderr, this.outputChannel);
								if (transport === TransportKind.ipc) {
									pipeStdout(sp.stdout, this.outputChannel);
									resolve({
										reader: new node_1.IPCMessageReader(this._serverProcess),
										writer: new node_1.IPCMessageWriter(this._serverProcess)
									});
								} else resolve({
									reader: new node_1.StreamMessageReader(sp.stdout),
									writer: new node_1.StreamMessageWriter(sp.stdin)
								});
							} else if (transport === TransportKind.pipe) (0, node_1.createClientPipeTransport)(pipeName).then((transport) => {
								const sp = cp.fork(node.module, args || [], options);
								assertStdio(sp);
								this._serverProcess = sp;
								pipeStderr(sp.stderr, this.outputChannel);
								pipeStdout(sp.stdout, this.outputChannel);
								waitForConnection(sp, transport).then(resolve, reject);
							}, reject);
							else if (Transport.isSocket(transport)) (0, node_1.createClientSocketTransport)(transport.port).then((transport) => {
								args.push(`--socket=${transport.port()}`);
								const sp = cp.fork(node.module, args || [], options);
								assertStdio(sp);
								this._serverProcess = sp;
								pipeStderr(sp.stderr, this.outputChannel);
								pipeStdout(sp.stdout, this.outputChannel);
								waitForConnection(sp, transport).then(resolve, reject);
							}, reject);
						});
					}
				} else if (Executable.is(json) && json.command) {
					const command = json;
					const args = json.args !== void 0 ? json.args.slice(0) : [];
					let pipeName = void 0;
					const transport = json.transport;
					if (transport === TransportKind.stdio) args.push("--stdio");
					else if (transport === TransportKind.pipe) {
						pipeName = (0, node_1.generateRandomPipeName)();
						args.push(`--pipe=${pipeName}`);
					} else if (transport === TransportKind.ipc) throw new Error(`Transport kind ipc is not support for command executable`);
					const options = Object.assign({}, command.options);
					options.cwd = options.cwd || serverWorkingDir;
					if (transport === void 0 || transport === TransportKind.stdio) {
						const serverProcess = cp.spawn(command.command, args, options);
						if (!serverProcess || !serverProcess.pid) return handleChildProcessStartError(serverProcess, `Launching server using command ${command.command} failed.`);
						pipeStderr(serverProcess.stderr, this.outputChannel);
						this._serverProcess = serverProcess;
						this._isDetached = !!options.detached;
						return Promise.resolve({
							reader: new node_1.StreamMessageReader(serverProcess.stdout),
							writer: new node_1.StreamMessageWriter(serverProcess.stdin)
						});
					} else if (transport === TransportKind.pipe) return (0, node_1.createClientPipeTransport)(pipeName).then((transport) => {
						const serverProcess = cp.spawn(command.command, args, options);
						if (!serverProcess || !serverProcess.pid) {
							transport.close();
							return handleChildProcessStartError(serverProcess, `Launching server using command ${command.command} failed.`);
						}
						this._serverProcess = serverProcess;
						this._isDetached = !!options.detached;
						pipeStderr(serverProcess.stderr, this.outputChannel);
						pipeStdout(serverProcess.stdout, this.outputChannel);
						return waitForConnection(serverProcess, transport);
					});
					else if (Transport.isSocket(transport)) return (0, node_1.createClientSocketTransport)(transport.port).then((transport) => {
						args.push(`--socket=${transport.port()}`);
						const serverProcess = cp.spawn(command.command, args, options);
						if (!serverProcess || !serverProcess.pid) {
							transport.close();
							return handleChildProcessStartError(serverProcess, `Launching server using command ${command.command} failed.`);
						}
						this._serverProcess = serverProcess;
						this._isDetached = !!options.detached;
						pipeStderr(serverProcess.stderr, this.outputChannel);
						pipeStdout(serverProcess.stdout, this.outputChannel);
						return waitForConnection(serverProcess, transport);
					});
				}
				return Promise.reject(/* @__PURE__ */ new Error(`Unsupported server configuration ` + JSON.stringify(server, null, 4)));
			};
			try {
				return await startServer(await this._getServerWorkingDir(json.options));
			} finally {
				if (this._serverProcess !== void 0) this._serverProcess.on("exit", (code, signal) => {
					if (code === 0) this.info("Server process exited successfully", void 0, false);
					else if (code !== null) this.error(`Server process exited with code ${code}.`, void 0, false);
					if (signal !== null) this.error(`Server process exited with signal ${signal}.`, void 0, false);
				});
			}
		}
		_getRuntimePath(runtime, serverWorkingDirectory) {
			if (path.isAbsolute(runtime)) return runtime;
			const mainRootPath = this._mainGetRootPath();
			if (mainRootPath !== void 0) {
				const result = path.join(mainRootPath, runtime);
				if (fs.existsSync(result)) return result;
			}
			if (serverWorkingDirectory !== void 0) {
				const result = path.join(serverWorkingDirectory, runtime);
				if (fs.existsSync(result)) return result;
			}
			return runtime;
		}
		_mainGetRootPath() {
			const folders = vscode_1.workspace.workspaceFolders;
			if (!folders || folders.length === 0) return;
			const folder = folders[0];
			if (folder.uri.scheme === "file") return folder.uri.fsPath;
		}
		_getServerWorkingDir(options) {
			let cwd = options && options.cwd;
			if (!cwd) cwd = this.clientOptions.workspaceFolder ? this.clientOptions.workspaceFolder.uri.fsPath : this._mainGetRootPath();
			if (cwd) return new Promise((s) => {
				fs.lstat(cwd, (err, stats) => {
					s(!err && stats.isDirectory() ? cwd : void 0);
				});
			});
			return Promise.resolve(void 0);
		}
	};
	exports.LanguageClient = LanguageClient;
	var SettingMonitor = class {
		_client;
		_setting;
		_listeners;
		constructor(_client, _setting) {
			this._client = _client;
			this._setting = _setting;
			this._listeners = [];
		}
		start() {
			vscode_1.workspace.onDidChangeConfiguration(this.onDidChangeConfiguration, this, this._listeners);
			this.onDidChangeConfiguration();
			return new vscode_1.Disposable(() => {
				if (this._client.needsStop()) this._client.stop();
			});
		}
		onDidChangeConfiguration() {
			const index = this._setting.indexOf(".");
			const primary = index >= 0 ? this._setting.substr(0, index) : this._setting;
			const rest = index >= 0 ? this._setting.substr(index + 1) : void 0;
			const enabled = rest ? vscode_1.workspace.getConfiguration(primary).get(rest, false) : vscode_1.workspace.getConfiguration(primary);
			if (enabled && this._client.needsStart()) this._client.start().catch((error) => this._client.error("Start failed after configuration change", error, "force"));
			else if (!enabled && this._client.needsStop()) this._client.stop().catch((error) => this._client.error("Stop failed after configuration change", error, "force"));
		}
	};
	exports.SettingMonitor = SettingMonitor;
	function waitForConnection(childProcess, transport) {
		return new Promise((resolve, reject) => {
			const removeListeners = () => {
				childProcess.removeListener("exit", onExit);
				childProcess.removeListener("error", onError);
			};
			const onExit = (code, signal) => {
				removeListeners();
				transport.close();
				reject(/* @__PURE__ */ new Error(`Server process exited before the connection could be established (code: ${code}, signal: ${signal}).`));
			};
			const onError = (error) => {
				removeListeners();
				transport.close();
				reject(error);
			};
			childProcess.once("exit", onExit);
			childProcess.once("error", onError);
			transport.onConnected().then((protocol) => {
				removeListeners();
				resolve({
					reader: protocol[0],
					writer: protocol[1]
				});
			}, (error) => {
				removeListeners();
				reject(error);
			});
		});
	}
	function handleChildProcessStartError(process, message) {
		if (process === null) return Promise.reject(message);
		return new Promise((_, reject) => {
			process.on("error", (err) => {
				reject(`${message} ${err}`);
			});
			setImmediate(() => reject(message));
		});
	}
})))();
/**
* The program that the setting `missionlab.path` means. A plain name is looked for in PATH, `~/` is the home folder, a
* relative path starts at the workspace's folder.
*/
function commandOf(setting, workspace, home) {
	const wanted = setting.trim() === "" ? "mlab" : setting.trim();
	if (wanted.startsWith("~/")) return node_path.join(home, wanted.slice(2));
	if (!wanted.includes("/") && !wanted.includes("\\") || node_path.isAbsolute(wanted)) return wanted;
	return workspace === void 0 ? wanted : node_path.join(workspace, wanted);
}
// src/extension.ts
var languages = [
	"cdl",
	"cnl",
	"mdl",
	"odl"
];
var client;
function serverOptions() {
	const setting = vscode.workspace.getConfiguration("missionlab").get("path", "mlab");
	const folder = vscode.workspace.workspaceFolders?.[0]?.uri.fsPath;
	return {
		command: commandOf(setting, folder, node_os.homedir()),
		args: ["lsp"],
		options: folder === void 0 ? {} : { cwd: folder }
	};
}
function clientOptions() {
	return {
		documentSelector: languages.map((language) => ({ language })),
		synchronize: { fileEvents: vscode.workspace.createFileSystemWatcher("**/*.{cdl,cnl,mdl,odl,ovl}") }
	};
}
async function start() {
	client = new import_main.LanguageClient("missionlab", "missionlab", serverOptions(), clientOptions());
	try {
		await client.start();
	} catch (error) {
		client = void 0;
		const why = error instanceof Error ? error.message : String(error);
		if (await vscode.window.showErrorMessage(`mlab could not be started: ${why}`, "Settings") === "Settings") await vscode.commands.executeCommand("workbench.action.openSettings", "missionlab.path");
	}
}
async function stop() {
	const running = client;
	client = void 0;
	await running?.stop();
}
async function activate(context) {
	context.subscriptions.push(vscode.commands.registerCommand("missionlab.restart", async () => {
		await stop();
		await start();
	}), vscode.workspace.onDidChangeConfiguration(async (change) => {
		if (!change.affectsConfiguration("missionlab.path")) return;
		await stop();
		await start();
	}));
	await start();
}
function deactivate() {
	return stop();
}
exports.activate = activate;
exports.deactivate = deactivate;
